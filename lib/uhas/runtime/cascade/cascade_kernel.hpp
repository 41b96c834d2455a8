// Definitions of Cascade (cascade.hpp) for the source files that instantiate it.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/runtime/cascade/cascade.hpp"

namespace uhas {

/// `a` where `mask` is true, else `b`.
template <class Num>
JointValue<Num> choose(MaskOf<Num> mask, const JointValue<Num>& a, const JointValue<Num>& b) {
  return {select(mask, a.q, b.q), select(mask, a.cosine, b.cosine), select(mask, a.sine, b.sine)};
}

template <class Num, class Wide>
Cascade<Num, Wide>::Cascade(const Model& model)
    : planes(model.tip_joint.size()), group_planes_(model.plane_groups.fingers.size()), joints_(model.joints.size()) {}

template <class Num, class Wide>
void Cascade<Num, Wide>::run(const Model& model) noexcept {
  const bool field = model.options.field == FieldReading::field;
  if constexpr (LaneTraits<Num>::width == 1) {
    if (field) average_planes(model), sum_points(model);
  }
  for (const SolverPart& part : model.parts) {
    begin_joints(model, part);
    if (!field) sum_targets(model, part);
    for (const Pass& pass : model.passes) sweep(model, part, pass);
    close_faded(model, part);
  }
}

// the plane that a finger's lateral joint and its contacts follow
template <class Num, class Wide>
const PlaneDeformation<Num>& Cascade<Num, Wide>::plane_of(const Model& model, int finger) const noexcept {
  return model.options.field == FieldReading::finger ? planes[finger] : group_planes_[model.group_of_finger[finger]];
}

template <class Num, class Wide>
void Cascade<Num, Wide>::average_planes(const Model& model) noexcept {
  for (std::size_t g = 0; g < group_planes_.size(); ++g)
    group_planes_[g] = mean_plane(planes, model.plane_groups.fingers[g], model.options.convention.held_toward_pole);
}

template <class Num, class Wide>
void Cascade<Num, Wide>::set_unknown(const Model& model, const SolverStep& step,
                                     const JointValue<Num>& value) noexcept {
  joints_[step.joint].set(value);
  if (step.single) return;
  for (int i : step.driven) {
    const SolverJoint<Real>& joint = model.joints[i];
    if (i != step.joint) joints_[i].set(joint.value(joint.motion_at(value.q)));
  }
}

// joint values before the cascade: lateral joints by table, all others where the rule starts from
template <class Num, class Wide>
void Cascade<Num, Wide>::begin_joints(const Model& model, const SolverPart& part) noexcept {
  JointState* const states = joints_.data();
  const SolverJoint<Real>* const joints = model.joints.data();
  for (const ScopedJoint& s : part.tree) {
    JointState& state = states[s.joint];
    state.value = joints[s.joint].start.template cast<Num>();
    state.at_start = true;
    state.at_limit = state.closed = Mask(false);
  }
  for (int k : part.laterals) {
    const SolverLateral<Real>& lateral = model.laterals[k];
    const Num& delta_theta = plane_of(model, lateral.finger).delta_theta;
    Num value;
    for (int l = 0; l < LaneTraits<Num>::width; ++l)
      set_lane(value, l, look_up_lateral<Real>(lateral.inverse_q, lateral.lower, lateral.upper, lane(delta_theta, l)));
    JointState& state = states[lateral.joint];
    const Mask moved = value != state.value.q;  // a lane that stands at its start keeps it, whatever the others do
    state.set(any(moved) ? choose(moved, joints[lateral.joint].value(value), state.value) : state.value);
  }
  for (int i : part.lateral_followers) {
    const SolverJoint<Real>& joint = joints[i];
    states[i].set(joint.value(joint.motion_at(states[joint.source].value.q)));
  }
}

// where a material point goes, and what closing leaves of it (docs/method.md#targets, docs/method.md#closing)
template <class Num, class Wide>
typename Cascade<Num, Wide>::Target Cascade<Num, Wide>::target_of(const Model& model,
                                                                  const SolverPoint<Real>& point) const noexcept {
  Displacement<Num> moved;
  if (model.options.field == FieldReading::finger) {
    const PlaneDeformation<Num>& plane = planes[point.finger];
    moved = {plane.delta_theta, plane.at(point.phi)};
  } else {
    moved = displacement_between(group_planes_[point.plane_before], group_planes_[point.plane_after], Num(point.blend),
                                 Num(point.phi));
  }
  const SinCos<Num> turn = sincos(model.azimuth_sign * moved.delta_theta);
  const Vector3<Num> t = max(point.rho + moved.radial.delta_r, Num(0)) * point.direction;
  return {{turn.cosine * t.x - turn.sine * t.y, turn.sine * t.x + turn.cosine * t.y, t.z},
          open_share<Num>(moved.radial, model.options.closing)};
}

// the moments of every joint's own points, one by one, in the interpolated field
template <class Num, class Wide>
void Cascade<Num, Wide>::sum_points(const Model& model) noexcept {
  for (JointState& state : joints_) state.own = {};
  for (const SolverPoint<Real>& point : model.points) {
    const Target target = target_of(model, point);
    joints_[point.joint].own.add(point.weight, target.share, point.p, target.t);
  }
}

// the same by patches, each on its finger's own plane; joints without points have none from the beginning
template <class Num, class Wide>
void Cascade<Num, Wide>::sum_targets(const Model& model, const SolverPart& part) noexcept {
  for (int f : part.fingers) {
    const SinCos<Num> turn = sincos(Num(model.azimuth_sign) * planes[f].delta_theta);
    for (int k : model.patches_of_finger[f]) {
      const SolverPatch<Real>& patch = model.patches[k];
      PointMoments<Num>& own = joints_[patch.joint].own;
      if (patch.first_of_joint) {
        sum_patch<Wide>(patch, planes[f], model.options.closing, own);
        own.turn_targets(turn.cosine, turn.sine);
      } else {
        PointMoments<Num> moments;
        sum_patch<Wide>(patch, planes[f], model.options.closing, moments);
        moments.turn_targets(turn.cosine, turn.sine);
        own.add(moments);
      }
    }
  }
}

// moments from the tips inward: what each joint carries, with the joints further out at their present values
template <class Num, class Wide>
void Cascade<Num, Wide>::carry_moments(const Model& model, std::span<const ScopedJoint> scope,
                                       const Pass& pass) noexcept {
  JointState* const states = joints_.data();
  const SolverJoint<Real>* const joints = model.joints.data();
  for (const ScopedJoint& s : scope) states[s.joint].carried = states[s.joint].own;
  for (std::size_t n = scope.size(); n-- > 0;) {
    if (!scope[n].inner) continue;
    const SolverJoint<Real>& joint = joints[scope[n].joint];
    const JointState& state = states[scope[n].joint];
    const Num factor = joint.decay_inward(Num(pass.decay));
    const RigidTransform<Num> scaled_T =
        pass.first && state.at_start
            ? joint.decayed_T_parent_start.template cast<Num>()
            : scaled(joint.moved(joint.T_parent_joint.template cast<Num>(), state.value), factor);
    states[joint.parent].carried.add_transformed(state.carried, scaled_T, factor);
  }
}

template <class Num, class Wide>
RigidTransform<Num> Cascade<Num, Wide>::frame_before_motion(const Model& model, int joint) const noexcept {
  const SolverJoint<Real>& j = model.joints[joint];
  const RigidTransform<Num> T_parent_joint = j.T_parent_joint.template cast<Num>();
  return j.parent < 0 ? T_parent_joint : joints_[j.parent].T_S_moved * T_parent_joint;
}

template <class Num, class Wide>
void Cascade<Num, Wide>::move_frames(const Model& model, std::span<const ScopedJoint> scope) noexcept {
  for (const ScopedJoint& s : scope)
    joints_[s.joint].T_S_moved =
        model.joints[s.joint].moved(frame_before_motion(model, s.joint), joints_[s.joint].value);
}

// one pass: unknowns that move several fingers first, then every joint from the palm outward, parents final, children
// as they are
template <class Num, class Wide>
void Cascade<Num, Wide>::sweep(const Model& model, const SolverPart& part, const Pass& pass) noexcept {
  carry_moments(model, part.tree, pass);
  for (int k : part.steps) {
    const SolverStep& step = model.steps[k];
    if (model.step_at[step.driven.front()] >= 0) continue;
    move_frames(model, part.tree);
    solve_step(model, step, frame_before_motion(model, step.driven.front()), pass);
    carry_moments(model, part.tree, pass);
  }
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

// `F` is the frame of the step's first joint before its own motion
template <class Num, class Wide>
void Cascade<Num, Wide>::solve_step(const Model& model, const SolverStep& step, const RigidTransform<Num>& F,
                                    const Pass& pass) noexcept {
  JointState& state = joints_[step.joint];
  Num full_weight = state.carried.full_weight, weight = state.carried.weight;
  if (!step.single) {
    full_weight = weight = Num(0);
    for (int i : step.driven) full_weight += joints_[i].carried.full_weight, weight += joints_[i].carried.weight;
  }
  Num open_share(1);
  if (!all(weight == full_weight)) {  // closing has taken some
    open_share = weight / select(full_weight > Num(0), full_weight, Num(1));
    if (model.options.closing == CascadeClosing::hard) open_share = select(open_share > Num(0), Num(1), open_share);
  }
  state.open_share = open_share;
  const Mask closed = open_share <= Num(0);
  const JointValue<Num> present = state.value;

  Fit fit{present, Mask(false)};
  if (!all(closed)) fit = fit_step(model, step, F, pass);
  if (any(closed)) {
    fit.value = choose(closed, present, fit.value);
    fit.at_limit = fit.at_limit & Mask(!closed);
  }
  set_unknown(model, step, fit.value);
  state.at_limit = fit.at_limit, state.closed = closed;
  if (step.single) return;
  for (int i : step.driven) joints_[i].at_limit = fit.at_limit, joints_[i].closed = closed;
}

template <class Num, class Wide>
typename Cascade<Num, Wide>::Fit Cascade<Num, Wide>::fit_step(const Model& model, const SolverStep& step,
                                                              const RigidTransform<Num>& F, const Pass& pass) noexcept {
  if constexpr (LaneTraits<Num>::width == 1) {  // the contact rule is not made for lanes
    if (model.options.rule == CascadeRule::contact) {
      const SolverJoint<Real>& joint = model.joints[step.joint];
      return within_limits(joint,
                           joint.value(step.single ? contact_single(model, step, F) : contact_group(model, step)));
    }
  }
  return step.single ? fit_single(model, step, F, pass) : fit_group(model, step, pass);
}

template <class Num, class Wide>
typename Cascade<Num, Wide>::Fit Cascade<Num, Wide>::within_limits(const SolverJoint<Real>& joint,
                                                                   const JointValue<Num>& value) const noexcept {
  const Mask below = value.q < Num(joint.lower.q);
  const Mask above = value.q > Num(joint.upper.q);
  const Mask outside = below | above;
  if (!any(outside)) return {value, outside};
  const JointValue<Num> held = choose(above, joint.upper.template cast<Num>(), value);
  return {choose(below, joint.lower.template cast<Num>(), held), outside};
}

// Each joint goes to its closed end by the share of points that closing has taken. Only now: a child fitted to a parent
// that has faded already would open to make up for it (measured on Allegro: a jump of 1 rad at delta r = -0.76).
template <class Num, class Wide>
void Cascade<Num, Wide>::close_faded(const Model& model, const SolverPart& part) noexcept {
  JointState* const states = joints_.data();
  const SolverStep* const steps = model.steps.data();
  for (const ScopedJoint& s : part.tree) states[s.joint].q = states[s.joint].value.q;
  for (int k : part.steps) {
    const SolverStep& step = steps[k];
    JointState& state = states[step.joint];
    const Mask whole = state.open_share == Num(1);
    if (all(whole)) continue;
    const SolverJoint<Real>& joint = model.joints[step.joint];
    const Num blend = state.open_share * state.q + (Num(1) - state.open_share) * Num(joint.q_closed);
    state.q = select(whole, state.q, clamp(blend, Num(joint.lower.q), Num(joint.upper.q)));
    for (int i : step.driven)
      if (i != step.joint) joints_[i].q = model.joints[i].motion_at(state.q);
  }
}

// The angle of least squares in closed form, from the present one: atan2 of the summed sines and cosines
// (docs/method.md#one-joint).
//
// A share of the points' own weight holds the joint where it is: where the targets come close to the axis and the sums
// nearly cancel, the angle would otherwise spin. What pulls backward, by more than a quarter turn, is left out: a
// target that passes behind the joint would otherwise throw it from one limit to the other (measured:
// docs/method.md#hold). At rest neither changes anything, and over several passes the hold fades, since it pulls to the
// pass before. The lead (docs/method.md#lead) turns the sums on by an angle, to first order.
template <class Num, class Wide>
typename Cascade<Num, Wide>::Fit Cascade<Num, Wide>::fit_single(const Model& model, const SolverStep& step,
                                                                const RigidTransform<Num>& F,
                                                                const Pass& pass) const noexcept {
  const Num zero(0), one(1), least(Real(1e-15f));  // with no weight at all the sums are zero and the joint stays
  const SolverJoint<Real>& j = model.joints[step.joint];
  const PointMoments<Num>& moments = joints_[step.joint].carried;
  const JointValue<Num>& present = joints_[step.joint].value;
  if (j.prismatic) {
    const Mask weighs = moments.weight > zero;
    const Num shift = fit_shift(moments, F) / select(weighs, moments.weight, one);
    return within_limits(j, j.value(select(weighs, shift, present.q)));
  }
  const Num arms = moments.p.x * moments.p.x + moments.p.y * moments.p.y;
  const Num hold = Num(Real(kHold)) * arms / (moments.weight + least * least) + least;
  const TurnFit<Num> fit = fit_turn(moments, F);
  const Num along = max(fit.cosine * present.cosine + fit.sine * present.sine, zero) + hold;
  const Num across = fit.sine * present.cosine - fit.cosine * present.sine;
  Num sine = across, cosine = along;
  if (pass.first) {
    const PlaneDeformation<Num>& plane = plane_of(model, step.first_finger);
    const Num lead = Num(j.lead[0]) * plane.lead[0] + Num(j.lead[1]) * plane.lead[1];
    sine += lead * along, cosine -= lead * across;
  }
  const Num per_length = one / sqrt(sine * sine + cosine * cosine);
  return within_limits(j,
                       {present.q + atan2(sine, cosine), (present.cosine * cosine - present.sine * sine) * per_length,
                        (present.cosine * sine + present.sine * cosine) * per_length});
}

// Joints coupled by mimics have no closed form: Newton's method follows the descent from the present value to the first
// minimum on the way, in steps of a quarter of the range at most and within the bracket it has found.
template <class Num, class Wide>
typename Cascade<Num, Wide>::Fit Cascade<Num, Wide>::fit_group(const Model& model, const SolverStep& step,
                                                               const Pass& pass) noexcept {
  constexpr int most_steps = 12;
  constexpr Real settled_step = std::is_same_v<Real, float> ? Real(1e-4) : Real(1e-6);  // the error left is its square
  const SolverJoint<Real>& joint = model.joints[step.joint];
  const Num lower(joint.lower.q), upper(joint.upper.q), longest = (upper - lower) * Num(Real(0.25)), zero(0);
  JointValue<Num> value = joints_[step.joint].value;
  Num below = lower, above = upper;  // the minimum lies between; an end that has not been evaluated is a limit
  Mask risen(false), fallen(false), settled(false), held(false);
  for (int n = 0; n < most_steps && !all(settled); ++n) {
    const Descent d = descent(model, step, value, pass);
    const Mask up = d.slope > zero, down = d.slope < zero, convex = d.bend < zero;
    below = select(up, value.q, below);
    above = select(down, value.q, above);
    risen = risen | up;
    fallen = fallen | down;
    const Mask outward = (up & (value.q >= upper)) | (down & (value.q <= lower)), moving = !settled;
    held = (settled & held) | (moving & outward);

    const Num away = select(up, longest, select(down, -longest, zero));
    const Num newton = select(convex, -d.slope / select(convex, d.bend, Num(1)), away);
    const Num aim = value.q + clamp(newton, -longest, longest);
    const Mask astray = risen & fallen & ((aim < below) | (aim > above));
    const Num next =
        select(settled, value.q, select(astray, (below + above) * Num(Real(0.5)), clamp(aim, lower, upper)));
    settled = settled | (abs(next - value.q) <= Num(settled_step));
    value = joint.value(next);
  }
  return {value, held};
}

// at this value of the group's unknown
template <class Num, class Wide>
typename Cascade<Num, Wide>::Descent Cascade<Num, Wide>::descent(const Model& model, const SolverStep& step,
                                                                 const JointValue<Num>& value,
                                                                 const Pass& pass) noexcept {
  set_unknown(model, step, value);
  carry_moments(model, step.scope, pass);
  move_frames(model, step.scope);
  const auto rate = [&](int i) { return Num(i == step.joint ? Real(1) : model.joints[i].ratio); };
  Descent sum{Num(0), Num(0)};
  for (int i : step.driven) {
    const PointMoments<Num>& moments = joints_[i].carried;
    const RigidTransform<Num>& T_S_moved = joints_[i].T_S_moved;
    if (model.joints[i].prismatic) {
      sum.slope += rate(i) * fit_shift(moments, T_S_moved);
      sum.bend -= rate(i) * rate(i) * moments.weight;
    } else {
      const TurnFit<Num> fit = fit_turn(moments, T_S_moved);
      sum.slope += rate(i) * fit.sine;
      sum.bend -= rate(i) * rate(i) * fit.cosine;
    }
  }
  for (const auto& [inner, outer] : step.nested)
    sum.bend += Num(2) * rate(inner) * rate(outer) *
                bend_of_pair(joints_[outer].carried, joints_[inner].T_S_moved, joints_[outer].T_S_moved);
  return sum;
}

template <class Num, class Wide>
double Cascade<Num, Wide>::residual_rms(const Model& model) noexcept {
  for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i].set(model.joints[i].value(joints_[i].q));
  for (const SolverPart& part : model.parts) move_frames(model, part.tree);
  double sum = 0, weight = 0;
  for (const SolverPoint<Real>& point : model.points) {
    const Target target = target_of(model, point);
    const Vector3<Real> error = joints_[point.joint].T_S_moved * point.p - target.t;
    const double w = double(point.weight) * double(target.share);
    sum += w * double(dot(error, error));
    weight += w;
  }
  return weight > 0 ? std::sqrt(sum / weight) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace uhas
