// Fingertips of many hands at once, one hand a lane: the one source of the kernels for each instruction set.
#pragma once

#include <cstddef>

#include "uhas/runtime/lanes/lane_math.hpp"
#include "uhas/runtime/lanes/lane_rows.hpp"
#include "uhas/runtime/observing/fingertip_chain.hpp"

namespace uhas {

/// The largest hand that wide kernels take.
inline constexpr std::size_t kKernelJoints = 64, kKernelFingers = 5;

/// What a wide kernel does, behind a boundary of plain pointers.
template <class Real>
struct FingertipKernel {
  /// Whether each of the numbers [count] is one that `place` takes: no angle beyond 1000 rad, nothing infinite, no NaN.
  bool (*takes)(const Real* numbers, std::size_t count);
  /// @param chains      [fingers]
  /// @param q           [hands][joints] rad, m
  /// @param fingertips  [hands][fingers][3] m, palm frame
  void (*place)(const FingertipChain<Real>* chains, std::size_t fingers, const Real* q, std::size_t joints,
                std::size_t hands, Real* fingertips);
};

template <class Real>
FingertipKernel<Real> fingertip_kernel_baseline();
template <class Real>
FingertipKernel<Real> fingertip_kernel_avx2();

template <class Num>
struct FingertipLanes {
  using Real = LaneReal<Num>;
  static constexpr std::size_t width = LaneTraits<Num>::width;

  static void place(const FingertipChain<Real>* chains, std::size_t fingers, const Real* q, std::size_t joints,
                    std::size_t hands, Real* fingertips) {
    const auto turn = [](Num angle, Num& cosine, Num& sine) {
      const SinCos<Num> turned = sincos(angle);
      cosine = turned.cosine, sine = turned.sine;
    };
    Num values[kKernelJoints], tips[3 * kKernelFingers];
    for (std::size_t first = 0; first < hands; first += width) {
      // a hand a lane; lanes past the last hand repeat it
      const std::size_t filled = hands - first < width ? hands - first : width;
      load_rows(q + first * joints, joints, filled, joints, values);

      // every joint value has its hands side by side: a chain is walked once for all of them
      for (std::size_t f = 0; f < fingers; ++f) {
        const Vector3<Num> p = place_fingertip<Num>(
            chains[f], [&](int joint) { return values[joint]; }, turn);
        tips[3 * f] = p.x, tips[3 * f + 1] = p.y, tips[3 * f + 2] = p.z;
      }
      store_rows(tips, filled, 3 * fingers, 3 * fingers, fingertips + first * 3 * fingers);
    }
  }

  static FingertipKernel<Real> kernel() { return {&LaneNumbers<Num>::takes, &place}; }
};

}  // namespace uhas
