// One finger through its walk, of one hand or of a hand a lane (docs/method.md#whole-fingers).
#pragma once

#include "uhas/runtime/cascade/affine_walk.hpp"
#include "uhas/runtime/cascade/cascade_kernel.hpp"

namespace uhas {

template <class Num>
WalkInput<Num> walk_input(const SolverModel<LaneReal<Num>>& model, const AffineFinger<LaneReal<Num>>& finger,
                          const PlaneDeformation<Num>& plane) {
  WalkInput<Num> in;
  in.vectors = plane.vectors;
  in.delta_r = plane.delta_r;
  in.leads = plane.lead;
  in.azimuth = Num(model.azimuth_sign) * plane.delta_theta;
  in.lateral = finger.lateral < 0 ? Num(0) : look_up_lateral(model.laterals[finger.lateral], plane.delta_theta);
  return in;
}

/// A finger that is whole in every lane.
/// @param place  place(joint, q)
template <class Num, class Place>
void walk_whole_finger(const AffineBundle<LaneReal<Num>>& bundle, const WalkInput<Num>& in, const Place& place) {
  const std::vector<int>& joints = bundle.fingers.front().joints;
  with_affine_sums<true>(bundle, in, [&](auto sums) {
    walk<true>(
        bundle, in, sums, [](int) { return MaskOf<Num>(false); },
        [&](int step, const Num& q, const MaskOf<Num>&) {
          if (joints[step] >= 0) place(joints[step], q);
        });
  });
}

/// A finger with points that fade: sums from these, and at the end each joint goes on to its closed end by what closing
/// has taken. The cascade holds the finger's plane.
template <class Num, class Visit, class Place>
void walk_faded_finger(const SolverModel<LaneReal<Num>>& model, const AffineBundle<LaneReal<Num>>& bundle,
                       const WalkInput<Num>& in, Cascade<Num, Visit>& cascade, const Place& place) {
  const AffineFinger<LaneReal<Num>>& finger = bundle.fingers.front();
  cascade.carry(model, model.parts[finger.part]);
  const PointMoments<Num> nothing;
  const auto carried = [&](int step) -> const PointMoments<Num>& {
    return finger.joints[step] < 0 ? nothing : cascade.carried(finger.joints[step]);
  };
  Num open_share;
  walk<true>(
      bundle, in, [&](int step) { return turn_sums(carried(step)); },
      [&](int step) {
        open_share = share_left(carried(step).weight, carried(step).full_weight, model.options.closing);
        return open_share <= Num(0);
      },
      [&](int step, const Num& q, const MaskOf<Num>&) {
        const int joint = finger.joints[step];
        if (joint >= 0) place(joint, step == bundle.before ? q : close_by_share(model.joints[joint], q, open_share));
      });
}

}  // namespace uhas
