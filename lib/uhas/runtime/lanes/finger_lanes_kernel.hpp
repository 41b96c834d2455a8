// The one source of every FingerLanes.
#pragma once

#include "uhas/runtime/cascade/affine_walk.hpp"
#include "uhas/runtime/lanes/finger_lanes.hpp"

namespace uhas {

template <class Num>
struct FingerLanesOf {
  using Real = LaneReal<Num>;
  static constexpr int width = LaneTraits<Num>::width;
  static_assert(width <= kMostFingerLanes);

  [[gnu::flatten]] static void walk(const AffineBundle<Real>& bundle, const FingerInput<Real>& input,
                                    const FadedSums<Real>& faded, const FingerOutput<Real>& output) {
    WalkInput<Num> in;
    for (int j = 0; j < input.vectors; ++j) in.delta_r[j] = load<Num>(input.delta_r[j]);
    for (int u = 0; u < kLeadInputs; ++u) in.leads[u] = load<Num>(input.leads[u]);
    in.azimuth = load<Num>(input.azimuth), in.lateral = load<Num>(input.lateral);

    const auto place = [&](int step, const Num& q, const MaskOf<Num>& at_limit) {
      store(q, output.q + step * width);
      store(select(at_limit, Num(1), Num(0)), output.at_limit + step * width);
    };
    with_vectors(input.vectors, [&](auto vectors) {
      constexpr int V = decltype(vectors)::value;
      if (faded.lanes == 0)
        uhas::walk<V, false>(
            bundle, in, [](int, TurnSums<Num>&) { return MaskOf<Num>(false); }, place);
      else
        uhas::walk<V, false>(bundle, in, FoundSums{lanes_of(faded.lanes), faded}, place);
    });
  }

  [[gnu::flatten]] static PointMoments<Real> visit(const PointColumns<Real>& columns,
                                                   const RadialProfile<Real>& profile, CascadeClosing closing) {
    return visit_side_by_side<Num>(columns, profile, closing);
  }

  [[gnu::flatten]] static SquaredErrors squared_errors(const PointColumns<Real>& columns,
                                                       const RadialProfile<Real>& profile, CascadeClosing closing,
                                                       const RigidTransform<Real>& T) {
    return uhas::squared_errors<Num>(columns, profile, closing, T);
  }

  static FingerLanes<Real> functions() { return {width, &walk, &visit, &squared_errors}; }

 private:
  /// Puts sums that were found point by point in the place of affine ones; says where nothing is left.
  struct FoundSums {
    MaskOf<Num> lanes;
    const FadedSums<Real>& found;

    MaskOf<Num> operator()(int step, TurnSums<Num>& sums) const {
      const Real* next = found.sums + step * kTurnSums * width;
      const auto replace = [&](Num& number) {
        number = select(lanes, load<Num>(next), number);
        next += width;
      };
      replace(sums.hold), replace(sums.p_x), replace(sums.p_y);
      replace(sums.row_x.x), replace(sums.row_x.y), replace(sums.row_x.z);
      replace(sums.row_y.x), replace(sums.row_y.y), replace(sums.row_y.z);
      return lanes & (load<Num>(found.open_share + step * width) <= Num(0));
    }
  };

  static MaskOf<Num> lanes_of(unsigned bits) {
    Num marks;
    for (int l = 0; l < width; ++l) set_lane(marks, l, Real(bits >> l & 1));
    return marks != Num(0);
  }
};

}  // namespace uhas
