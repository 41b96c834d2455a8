// The one source of every FingerLanes.
#pragma once

#include "uhas/runtime/cascade/affine_walk.hpp"
#include "uhas/runtime/lanes/finger_lanes.hpp"

namespace uhas {

/// @tparam Num     a finger a lane
/// @tparam Points  points of a patch side by side
template <class Num, class Points>
struct FingerLanesOf {
  using Real = LaneReal<Num>;
  static constexpr int width = LaneTraits<Num>::width;
  static_assert(width <= kMostFingerLanes);

  [[gnu::flatten]] static void walk_whole(const AffineBundle<Real>& bundle, const FingerInput<Real>& input,
                                          const FingerMemory<Real>& memory) {
    const WalkInput<Num> in = input_of(input);
    with_affine_sums<false>(bundle, in, [&](auto sums) {
      walk<false>(
          bundle, in, sums, [](int) { return MaskOf<Num>(false); },
          [&](int step, const Num& q, const MaskOf<Num>& at_limit) { place(memory, step, q, at_limit); });
    });
  }

  [[gnu::flatten]] static void affine_sums(const AffineBundle<Real>& bundle, const FingerInput<Real>& input,
                                           const FingerMemory<Real>& memory) {
    const WalkInput<Num> in = input_of(input);
    with_affine_sums<false>(bundle, in, [&](auto sums_of) {
      for (int step = 0; step < bundle.steps(); ++step) {
        store(Num(1), memory.open_share + step * width);
        if (step == bundle.before) continue;
        TurnSums<Num> sums = sums_of(step);
        each_number(sums, [next = memory.sums + step * kTurnSums * width](const Num& number) mutable {
          store(number, next);
          next += width;
        });
      }
    });
  }

  [[gnu::flatten]] static void walk_sums(const AffineBundle<Real>& bundle, const FingerInput<Real>& input,
                                         const FingerMemory<Real>& memory) {
    const auto sums_of = [&](int step) {
      TurnSums<Num> sums;
      each_number(sums, [next = memory.sums + step * kTurnSums * width](Num& number) mutable {
        number = load<Num>(next);
        next += width;
      });
      return sums;
    };
    walk<false>(
        bundle, input_of(input), sums_of,
        [&](int step) { return load<Num>(memory.open_share + step * width) <= Num(0); },
        [&](int step, const Num& q, const MaskOf<Num>& at_limit) { place(memory, step, q, at_limit); });
  }

  [[gnu::flatten]] static PointMoments<Real> visit(const PointColumns<Real>& columns,
                                                   const RadialProfile<Real>& profile, CascadeClosing closing) {
    return visit_side_by_side<Points>(columns, profile, closing);
  }

  [[gnu::flatten]] static SquaredErrors squared_errors(const PointColumns<Real>& columns,
                                                       const RadialProfile<Real>& profile, CascadeClosing closing,
                                                       const RigidTransform<Real>& T) {
    return uhas::squared_errors<Points>(columns, profile, closing, T);
  }

  static FingerLanes<Real> functions() {
    return {width, &walk_whole, &affine_sums, &walk_sums, &visit, &squared_errors};
  }

 private:
  static void place(const FingerMemory<Real>& memory, int step, const Num& q, const MaskOf<Num>& at_limit) {
    store(q, memory.q + step * width);
    store(select(at_limit, Num(1), Num(0)), memory.at_limit + step * width);
  }

  static WalkInput<Num> input_of(const FingerInput<Real>& input) {
    WalkInput<Num> in;
    in.vectors = input.vectors;
    for (int j = 0; j < kMaxDrivingVectors; ++j) in.delta_r[j] = load<Num>(input.delta_r[j]);
    for (int u = 0; u < kLeadInputs; ++u) in.leads[u] = load<Num>(input.leads[u]);
    in.azimuth = load<Num>(input.azimuth), in.lateral = load<Num>(input.lateral);
    return in;
  }
};

}  // namespace uhas
