// The cascade (docs/method.md#the-cascade): definitions of Cascade (cascade.hpp), in the order they run.
// Source files that instantiate it for plain numbers add point_targets.hpp and contact_rule.hpp.
#pragma once

#include <type_traits>

#include "uhas/runtime/cascade/cascade.hpp"
#include "uhas/runtime/cascade/coupled_joints.hpp"
#include "uhas/runtime/cascade/patch_moments.hpp"
#include "uhas/runtime/lanes/lateral_lanes.hpp"

namespace uhas {

/// `a` where `mask` is true, else `b`.
template <class Num>
JointValue<Num> choose(MaskOf<Num> mask, const JointValue<Num>& a, const JointValue<Num>& b) {
  return {select(mask, a.q, b.q), select(mask, a.cosine, b.cosine), select(mask, a.sine, b.sine)};
}

/// What is left of a step's weight, alpha (docs/method.md#closing); `hard` knows all or nothing.
template <class Num>
Num share_left(Num weight, Num full_weight, CascadeClosing closing) {
  if (all(weight == full_weight)) return Num(1);
  const Num share = weight / select(full_weight > Num(0), full_weight, Num(1));
  return closing == CascadeClosing::hard ? select(share > Num(0), Num(1), share) : share;
}

/// A joint value that has closed by what is not left of its points: the share of the fitted value, the rest of the closed
/// end (docs/method.md#closing).
template <class Num, class Real>
Num close_by_share(const SolverJoint<Real>& joint, Num q, Num open_share) {
  const Num blend = open_share * q + (Num(1) - open_share) * Num(joint.travel.closed);
  return select(open_share == Num(1), q, clamp(blend, Num(joint.lower.q), Num(joint.upper.q)));
}

template <class Num, class Visit>
Cascade<Num, Visit>::Cascade(const Model& model, Visit visit)
    : planes(model.tips.size()),
      visit_(visit),
      group_planes_(model.plane_groups.fingers.size()),
      joints_(model.joints.size()) {}

template <class Num, class Visit>
void Cascade<Num, Visit>::begin(const Model& model) noexcept {
  // the interpolated field mixes fingers: its targets are summed for the whole hand at once
  if constexpr (std::is_floating_point_v<Num>) {
    if (model.options.field == FieldReading::field) average_planes(model), sum_points(model);
  }
}

template <class Num, class Visit>
void Cascade<Num, Visit>::run(const Model& model, const SolverPart& part) noexcept {
  // joints to their start, targets to moments
  begin_joints(model, part);
  if (model.options.field == FieldReading::finger) sum_targets(model, part, true);
  // fit joint by joint, once or several times
  for (const Pass& pass : model.passes) sweep(model, part, pass);
  // only then close what has lost its points
  close_faded(model, part);
}

/// the plane that a finger's lateral joint and its contacts follow
template <class Num, class Visit>
const PlaneDeformation<Num>& Cascade<Num, Visit>::plane_of(const Model& model, int finger) const noexcept {
  return model.options.field == FieldReading::finger ? planes[finger]
                                                     : group_planes_[model.plane_groups.of_finger[finger]];
}

/// joint values before the cascade
template <class Num, class Visit>
void Cascade<Num, Visit>::begin_joints(const Model& model, const SolverPart& part) noexcept {
  JointState* const states = joints_.data();
  const SolverJoint<Real>* const joints = model.joints.data();
  const SolverStart<Real>* const starts = model.starts.data();
  // all where the rule starts from
  for (const ScopedJoint& s : part.tree) {
    JointState& state = states[s.joint];
    state.value = starts[s.joint].value.template cast<Num>();
    state.at_start = true;
    state.at_limit = state.closed = Mask(false);
  }
  // lateral joints by their table; a lane that stands at its start keeps it, whatever the others do
  for (int k : part.laterals) {
    const SolverLateral<Real>& lateral = model.laterals[k];
    const Num& delta_theta = plane_of(model, lateral.finger).delta_theta;
    const Num value = look_up_lateral(lateral, delta_theta);
    JointState& state = states[lateral.joint];
    const Mask moved = value != state.value.q;
    state.set(any(moved) ? choose(moved, joints[lateral.joint].value(value), state.value) : state.value);
  }
  // joints that mimic one of these
  for (int i : part.lateral_followers) {
    const SolverJoint<Real>& joint = joints[i];
    states[i].set(joint.value(joint.motion_at(states[joint.source].value.q)));
  }
}

/// the moments of every joint's own points, patch by patch, each on its finger's own plane; joints without points have
/// none from the beginning
template <class Num, class Visit>
void Cascade<Num, Visit>::sum_targets(const Model& model, const SolverPart& part, bool turned) noexcept {
  for (int f : part.fingers) {
    SinCos<Num> turn{Num(0), Num(1)};
    if (turned) turn = sincos(Num(model.azimuth_sign) * planes[f].delta_theta);
    for (int k : model.patches_of_finger[f]) {
      const SolverPatch<Real>& patch = model.patches[k];
      PointMoments<Num>& own = joints_[patch.joint].own;
      // displacements from the plane, then the azimuth turns the sums; a joint's first patch begins its sums
      if (patch.first_of_joint) {
        sum_patch(patch, planes[f], model.options.closing, visit_, own);
        if (turned) own.turn_targets(turn.cosine, turn.sine);
      } else {
        PointMoments<Num> moments;
        sum_patch(patch, planes[f], model.options.closing, visit_, moments);
        if (turned) moments.turn_targets(turn.cosine, turn.sine);
        own.add(moments);
      }
    }
  }
}

/// one pass (docs/method.md#passes)
template <class Num, class Visit>
void Cascade<Num, Visit>::sweep(const Model& model, const SolverPart& part, const Pass& pass) noexcept {
  // inward: what each joint carries
  carry_moments(model, part.tree, pass);
  // coupled joints that move several fingers, before any of these
  for (int k : part.steps) {
    const SolverStep& step = model.steps[k];
    if (model.step_at[step.driven.front()] >= 0) continue;
    move_frames(model, part.tree);
    solve_step(model, step, frame_before_motion(model, step.driven.front()), pass);
    carry_moments(model, part.tree, pass);
  }
  // outward: joint by joint, parents final, children as they are
  JointState* const states = joints_.data();
  const SolverJoint<Real>* const joints = model.joints.data();
  const SolverStep* const steps = model.steps.data();
  const int* const step_at = model.step_at.data();
  for (const ScopedJoint& s : part.tree) {
    const RigidTransform<Num> F = frame_before_motion(model, s.joint);
    const int k = step_at[s.joint];
    if (k >= 0) solve_step(model, steps[k], F, pass);
    states[s.joint].T_S_moved = joints[s.joint].moved(F, states[s.joint].value);
  }
}

/// moments from the tips inward, with the joints further out at their present values (docs/method.md#moments)
template <class Num, class Visit>
void Cascade<Num, Visit>::carry_moments(const Model& model, std::span<const ScopedJoint> scope,
                                        const Pass& pass) noexcept {
  JointState* const states = joints_.data();
  const SolverJoint<Real>* const joints = model.joints.data();
  const SolverStart<Real>* const starts = model.starts.data();
  // each joint carries its own points
  for (const ScopedJoint& s : scope) states[s.joint].carried = states[s.joint].own;
  // and, from the last joint to the first, what its children carry, moved to its frame and decayed
  for (std::size_t n = scope.size(); n-- > 0;) {
    if (!scope[n].inner) continue;
    const SolverJoint<Real>& joint = joints[scope[n].joint];
    const JointState& state = states[scope[n].joint];
    const Num factor = joint.decay_inward(Num(pass.decay));
    const RigidTransform<Num> scaled_T =
        pass.first && state.at_start
            ? starts[scope[n].joint].decayed_T_parent_moved.template cast<Num>()
            : scaled(joint.moved(joint.T_parent_joint.template cast<Num>(), state.value), factor);
    states[joint.parent].carried.add_transformed(state.carried, scaled_T, factor);
  }
}

/// the joint's frame F in S, its parents moved and the joint itself not
template <class Num, class Visit>
RigidTransform<Num> Cascade<Num, Visit>::frame_before_motion(const Model& model, int joint) const noexcept {
  const SolverJoint<Real>& j = model.joints[joint];
  const RigidTransform<Num> T_parent_joint = j.T_parent_joint.template cast<Num>();
  return j.parent < 0 ? T_parent_joint : joints_[j.parent].T_S_moved * T_parent_joint;
}

template <class Num, class Visit>
void Cascade<Num, Visit>::move_frames(const Model& model, std::span<const ScopedJoint> scope) noexcept {
  for (const ScopedJoint& s : scope)
    joints_[s.joint].T_S_moved =
        model.joints[s.joint].moved(frame_before_motion(model, s.joint), joints_[s.joint].value);
}

/// `F` is the frame of the step's first joint before its own motion
template <class Num, class Visit>
void Cascade<Num, Visit>::solve_step(const Model& model, const SolverStep& step, const RigidTransform<Num>& F,
                                     const Pass& pass) noexcept {
  JointState& state = joints_[step.joint];
  // the weight that the step carries, with and without what closing has taken
  Num full_weight = state.carried.full_weight, weight = state.carried.weight;
  if (!step.single) {
    full_weight = weight = Num(0);
    for (int i : step.driven) full_weight += joints_[i].carried.full_weight, weight += joints_[i].carried.weight;
  }
  const Num open_share = share_left(weight, full_weight, model.options.closing);
  state.open_share = open_share;

  // fit where anything is left; elsewhere the joint stays until `close_faded`
  const Mask closed = open_share <= Num(0);
  const JointValue<Num> present = state.value;
  Fit fit{present, Mask(false)};
  if (!all(closed)) fit = fit_step(model, step, F, pass);
  if (any(closed)) {
    fit.value = choose(closed, present, fit.value);
    fit.at_limit = fit.at_limit & Mask(!closed);
  }

  // the joint and its followers
  set_unknown(model, step, fit.value);
  state.at_limit = fit.at_limit, state.closed = closed;
  if (step.single) return;
  for (int i : step.driven) joints_[i].at_limit = fit.at_limit, joints_[i].closed = closed;
}

template <class Num, class Visit>
typename Cascade<Num, Visit>::Fit Cascade<Num, Visit>::fit_step(const Model& model, const SolverStep& step,
                                                                const RigidTransform<Num>& F,
                                                                const Pass& pass) noexcept {
  if constexpr (std::is_floating_point_v<Num>) {  // the contact rule is made for plain numbers
    if (model.options.rule == CascadeRule::contact) {
      const SolverJoint<Real>& joint = model.joints[step.joint];
      return within_limits(joint,
                           joint.value(step.single ? contact_single(model, step, F) : contact_group(model, step)));
    }
  }
  return step.single ? fit_single(model, step, F, pass) : fit_group(model, step, pass);
}

/// The value of least squares in closed form, seen from the present one (docs/method.md#one-joint).
template <class Num, class Visit>
typename Cascade<Num, Visit>::Fit Cascade<Num, Visit>::fit_single(const Model& model, const SolverStep& step,
                                                                  const RigidTransform<Num>& F,
                                                                  const Pass& pass) const noexcept {
  const Num zero(0), one(1);
  const SolverJoint<Real>& j = model.joints[step.joint];
  const PointMoments<Num>& moments = joints_[step.joint].carried;
  const JointValue<Num>& present = joints_[step.joint].value;

  // a slide goes by the mean distance of targets from points along its axis
  if (j.prismatic) {
    const Mask weighs = moments.weight > zero;
    const Num shift = fit_shift(moments, F) / select(weighs, moments.weight, one);
    return within_limits(j, j.value(select(weighs, shift, present.q)));
  }

  // what the sums pull along the present angle (A) and across it (B); a pull backward, by more than a quarter turn, is
  // left out, or a target that passes behind the joint would throw it from one limit to the other
  const TurnSums<Num> sums = turn_sums(moments);
  const TurnFit<Num> fit = fit_turn(sums, F);
  const Num along = max(fit.cosine * present.cosine + fit.sine * present.sine, zero) + sums.hold;
  const Num across = fit.sine * present.cosine - fit.cosine * present.sine;

  // in the first pass the lead turns (A, B) on, to first order, for the joints further out (docs/method.md#lead)
  Num sine = across, cosine = along;
  if (pass.first) {
    const SolverLead<Real>& lead_of = model.leads[step.joint];
    const PlaneDeformation<Num>& plane = plane_of(model, step.first_finger);
    const Num lead = Num(lead_of[0]) * plane.lead[0] + Num(lead_of[1]) * plane.lead[1];
    sine += lead * along, cosine -= lead * across;
  }

  // q = q0 + atan2(B, A), its sine and cosine by the sums of angles
  const Num per_length = one / sqrt(sine * sine + cosine * cosine);
  return within_limits(j,
                       {present.q + atan2(sine, cosine), (present.cosine * cosine - present.sine * sine) * per_length,
                        (present.cosine * sine + present.sine * cosine) * per_length});
}

/// `value` clamped; cosine and sine of the limits are at hand
template <class Num, class Visit>
typename Cascade<Num, Visit>::Fit Cascade<Num, Visit>::within_limits(const SolverJoint<Real>& joint,
                                                                     const JointValue<Num>& value) const noexcept {
  const Mask below = value.q < Num(joint.lower.q);
  const Mask above = value.q > Num(joint.upper.q);
  const Mask outside = below | above;
  if (!any(outside)) return {value, outside};
  const JointValue<Num> held = choose(above, joint.upper.template cast<Num>(), value);
  return {choose(below, joint.lower.template cast<Num>(), held), outside};
}

/// the step's joint to `value`, its followers after it
template <class Num, class Visit>
void Cascade<Num, Visit>::set_unknown(const Model& model, const SolverStep& step,
                                      const JointValue<Num>& value) noexcept {
  joints_[step.joint].set(value);
  if (step.single) return;
  for (int i : step.driven) {
    const SolverJoint<Real>& joint = model.joints[i];
    if (i != step.joint) joints_[i].set(joint.value(joint.motion_at(value.q)));
  }
}

/// Each joint goes to its closed end by the share of points that closing has taken (docs/method.md#closing). Only now: a
/// child fitted to a parent that has faded already would open to make up for it.
template <class Num, class Visit>
void Cascade<Num, Visit>::close_faded(const Model& model, const SolverPart& part) noexcept {
  JointState* const states = joints_.data();
  const SolverStep* const steps = model.steps.data();
  // a joint that has lost nothing stands where the cascade has put it
  for (const ScopedJoint& s : part.tree) states[s.joint].q = states[s.joint].value.q;
  for (int k : part.steps) {
    const SolverStep& step = steps[k];
    JointState& state = states[step.joint];
    if (all(state.open_share == Num(1))) continue;
    state.q = close_by_share(model.joints[step.joint], state.q, state.open_share);
    // followers after it
    for (int i : step.driven)
      if (i != step.joint) joints_[i].q = model.joints[i].motion_at(state.q);
  }
}

}  // namespace uhas
