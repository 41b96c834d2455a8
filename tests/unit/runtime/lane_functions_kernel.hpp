// The one source of both compilations of LaneFunctions.
#pragma once

#include "uhas/runtime/lanes/lane_math.hpp"
#include "unit/runtime/lane_functions.hpp"

namespace uhas::test {

template <class Num>
struct LaneLoops {
  using Real = LaneReal<Num>;
  static constexpr int width = LaneTraits<Num>::width;

  static void sincos_all(const Real* x, int count, Real* sine, Real* cosine) {
    for (int i = 0; i < count; i += width) {
      const SinCos<Num> result = sincos(load<Num>(x + i));
      store(result.sine, sine + i);
      store(result.cosine, cosine + i);
    }
  }

  static void atan2_all(const Real* y, const Real* x, int count, Real* angle) {
    for (int i = 0; i < count; i += width) store(atan2(load<Num>(y + i), load<Num>(x + i)), angle + i);
  }

  static void operate(const Real* a_from, const Real* b_from, int count, Real* const* out) {
    for (int i = 0; i < count; i += width) {
      const Num a = load<Num>(a_from + i), b = load<Num>(b_from + i), seven(7);
      Num picked = a;
      for (int k = 0; k < width; ++k) set_lane(picked, k, lane(b, width - 1 - k));  // b backwards, read below
      Num restored = picked;
      for (int k = 0; k < width; ++k) set_lane(restored, k, lane(picked, width - 1 - k));
      const Num results[kLaneOperations] = {a + restored,
                                            a - b,
                                            a * b,
                                            a / b,
                                            -a,
                                            min(a, b),
                                            max(a, b),
                                            clamp(a, Num(0), b),
                                            abs(a),
                                            sqrt(abs(a)),
                                            select(a < b, a, seven),
                                            select((a <= b) & !(a == b), a, seven),
                                            select((a > b) | (b != b), a, seven),
                                            Num(sum(a)),
                                            Num(any(a >= b) ? Real(1) : Real(0)),
                                            Num(all(a >= b) ? Real(1) : Real(0))};
      for (int k = 0; k < kLaneOperations; ++k) store(results[k], out[k] + i);
    }
  }

  static LaneFunctions<Real> functions() { return {width, &sincos_all, &atan2_all, &operate}; }
};

}  // namespace uhas::test
