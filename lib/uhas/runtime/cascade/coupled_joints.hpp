// Coupled joints (docs/method.md#coupled-joints): definitions of Cascade for unknowns that move several joints.
#pragma once

#include <type_traits>

#include "uhas/runtime/cascade/cascade.hpp"

namespace uhas {

/// Joints coupled by mimics have no closed form: Newton's method follows the descent from the present value to the first
/// minimum on the way, in steps of a quarter of the range at most and within the bracket it has found.
template <class Num, class Visit>
typename Cascade<Num, Visit>::Fit Cascade<Num, Visit>::fit_group(const Model& model, const SolverStep& step,
                                                                 const Pass& pass) noexcept {
  constexpr int most_steps = 12;
  constexpr Real settled_step = std::is_same_v<Real, float> ? Real(1e-4) : Real(1e-6);  // the error left is its square
  const SolverJoint<Real>& joint = model.joints[step.joint];
  const Num lower(joint.lower.q), upper(joint.upper.q), longest = (upper - lower) * Num(Real(0.25)), zero(0);
  JointValue<Num> value = joints_[step.joint].value;
  Num below = lower, above = upper;  // the minimum lies between; an end that has not been evaluated is a limit
  Mask risen(false), fallen(false), settled(false), held(false);
  for (int n = 0; n < most_steps && !all(settled); ++n) {
    // which way is down, and the bracket that follows
    const Descent d = descent(model, step, value, pass);
    const Mask up = d.slope > zero, down = d.slope < zero, convex = d.bend < zero;
    below = select(up, value.q, below);
    above = select(down, value.q, above);
    risen = risen | up;
    fallen = fallen | down;
    // a lane that still moves is held where the way down leads out of the limits
    const Mask outward = (up & (value.q >= upper)) | (down & (value.q <= lower)), moving = !settled;
    held = (settled & held) | (moving & outward);

    // Newton's step where the cost is convex, else the longest one downhill
    const Num away = select(up, longest, select(down, -longest, zero));
    const Num newton = select(convex, -d.slope / select(convex, d.bend, Num(1)), away);
    const Num aim = value.q + clamp(newton, -longest, longest);
    // out of a bracket whose ends are both known: its middle instead
    const Mask astray = risen & fallen & ((aim < below) | (aim > above));
    const Num next =
        select(settled, value.q, select(astray, (below + above) * Num(Real(0.5)), clamp(aim, lower, upper)));
    settled = settled | (abs(next - value.q) <= Num(settled_step));
    value = joint.value(next);
  }
  return {value, held};
}

/// slope and bend at this value of the group's unknown
template <class Num, class Visit>
typename Cascade<Num, Visit>::Descent Cascade<Num, Visit>::descent(const Model& model, const SolverStep& step,
                                                                   const JointValue<Num>& value,
                                                                   const Pass& pass) noexcept {
  // the joints at that value, with moments and frames to match
  set_unknown(model, step, value);
  carry_moments(model, step.scope, pass);
  move_frames(model, step.scope);
  // each joint by itself, as fast as the unknown moves it
  const auto rate = [&](int i) { return Num(i == step.joint ? Real(1) : model.joints[i].ratio); };
  Descent sum{Num(0), Num(0)};
  for (int i : step.driven) {
    const PointMoments<Num>& moments = joints_[i].carried;
    const RigidTransform<Num>& T_S_moved = joints_[i].T_S_moved;
    if (model.joints[i].prismatic) {
      sum.slope += rate(i) * fit_shift(moments, T_S_moved);
      sum.bend -= rate(i) * rate(i) * moments.weight;
    } else {
      const TurnFit<Num> fit = fit_turn(turn_sums(moments), T_S_moved);
      sum.slope += rate(i) * fit.sine;
      sum.bend -= rate(i) * rate(i) * fit.cosine;
    }
  }
  // and pairs of which one carries the other
  for (const auto& [inner, outer] : step.nested)
    sum.bend += Num(2) * rate(inner) * rate(outer) *
                bend_of_pair(joints_[outer].carried, joints_[inner].T_S_moved, joints_[outer].T_S_moved);
  return sum;
}

}  // namespace uhas
