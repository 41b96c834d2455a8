#include "uhas/runtime/cascade_detail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "uhas/runtime/lateral_lookup.hpp"

namespace uhas {
namespace {

/// Factor on a point's weight for each unknown between it and the joint being solved, in the first pass (design 3.8).
constexpr double kDecay = 0.3;

}  // namespace

template <class Real>
Cascade<Real>::Cascade(const SolverModel<Real>& model)
    : planes(model.tip_joint.size()),
      q(model.joints.size()),
      at_limit(model.joints.size()),
      closed(model.joints.size()),
      group_planes_(model.plane_groups.size()),
      values_(model.joints.size()),
      T_parent_moved_(model.joints.size()),
      T_moved_(model.joints.size()),
      own_(model.joints.size()),
      carried_(model.joints.size()),
      open_share_(model.joints.size()) {}

template <class Real>
void Cascade<Real>::run(const SolverModel<Real>& model) noexcept {
  if (model.options.field == FieldReading::field) average_planes(model);
  begin_joints(model);
  sum_targets(model);
  const int passes = model.options.rule == Rule::contact ? 1 : model.options.passes;
  for (int pass = 0; pass < passes; ++pass) {
    // the decay rises to 1 over the passes: the last ones descend on the plain weights
    decay_ = static_cast<Real>(passes > 1 ? std::pow(kDecay, 1.0 - double(pass) / double(passes - 1)) : kDecay);
    sweep(model);
  }
  close_faded(model);
}

// the plane that a finger's lateral joint and its contacts follow
template <class Real>
const PlaneDeformation<Real>& Cascade<Real>::plane_of(const SolverModel<Real>& model, int finger) const noexcept {
  return model.options.field == FieldReading::finger ? planes[finger] : group_planes_[model.group_of_finger[finger]];
}

template <class Real>
void Cascade<Real>::average_planes(const SolverModel<Real>& model) noexcept {
  for (std::size_t g = 0; g < group_planes_.size(); ++g) {
    PlaneDeformation<Real> mean;
    const Real share = Real(1) / Real(model.plane_groups[g].size());
    for (int finger : model.plane_groups[g]) {
      mean.vectors = planes[finger].vectors;
      mean.delta_theta += share * planes[finger].delta_theta;
      for (int j = 0; j < mean.vectors; ++j) {
        mean.phi[j] += share * planes[finger].phi[j];
        mean.delta_r[j] += share * planes[finger].delta_r[j];
      }
    }
    group_planes_[g] = mean;
  }
}

template <class Real>
void Cascade<Real>::set_joint(const SolverModel<Real>& model, int joint, const JointValue<Real>& value) noexcept {
  values_[joint] = value;
  T_parent_moved_[joint] = model.joints[joint].moved(model.joints[joint].T_parent_joint, value);
}

template <class Real>
void Cascade<Real>::set_unknown(const SolverModel<Real>& model, const SolverStep& step, const JointValue<Real>& value) noexcept {
  set_joint(model, step.joint, value);
  for (int i : step.driven)
    if (i != step.joint) set_joint(model, i, model.joints[i].value(model.joints[i].multiplier * value.q + model.joints[i].offset));
}

// joint values before the cascade: lateral joints by table, all others where the rule starts from
template <class Real>
void Cascade<Real>::begin_joints(const SolverModel<Real>& model) noexcept {
  for (std::size_t i = 0; i < values_.size(); ++i) set_joint(model, static_cast<int>(i), model.joints[i].start);
  for (const SolverLateral<Real>& lateral : model.laterals) {
    const Real value = look_up_lateral<Real>(lateral.inverse_q, lateral.lower, lateral.upper, plane_of(model, lateral.finger).delta_theta);
    if (value != values_[lateral.joint].q) set_joint(model, lateral.joint, model.joints[lateral.joint].value(value));
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const SolverJoint<Real>& joint = model.joints[i];
    if (joint.master >= 0) set_joint(model, static_cast<int>(i), joint.value(joint.multiplier * values_[joint.master].q + joint.offset));
  }
  std::fill(at_limit.begin(), at_limit.end(), std::uint8_t{0});
  std::fill(closed.begin(), closed.end(), std::uint8_t{0});
}

// where a material point goes before the azimuth turns, and what closing leaves of it (design 3.7 and 3.8)
template <class Real>
typename Cascade<Real>::Target Cascade<Real>::target_of(const SolverModel<Real>& model, const SolverPoint<Real>& point) const noexcept {
  const bool field = model.options.field == FieldReading::field;
  const PlaneDeformation<Real>& before = field ? group_planes_[point.plane_before] : planes[point.finger];
  const PlaneDeformation<Real>& after = field ? group_planes_[point.plane_after] : before;
  const auto between = [&](Real a, Real b) { return field ? a + point.blend * (b - a) : a; };
  const auto radial = [&](Real phi) { return field ? between(before.radial(phi), after.radial(phi)) : before.radial(phi); };

  const Real delta_r = radial(point.phi);
  Real share = Real(1) + delta_r < Real(0) ? Real(0) : Real(1);
  if (model.options.closing == Closing::fade) {
    // the anchored pole must not keep a root open, so short of the first driving vector that one decides
    const Real first_phi = between(before.phi[0], after.phi[0]);
    const Real u = std::clamp((Real(1) + (point.phi < first_phi ? radial(first_phi) : delta_r)) * Real(2), Real(0), Real(1));
    share = u * u * (Real(3) - Real(2) * u);
  }
  Vector3<Real> t = std::max(point.rho + delta_r, Real(0)) * point.direction;
  const Real turn = model.azimuth_sign * between(before.delta_theta, after.delta_theta);
  const Real c = std::cos(turn), s = std::sin(turn);
  t = {c * t.x - s * t.y, s * t.x + c * t.y, t.z};
  return {t, share};
}

// the moments of every joint's own points
template <class Real>
void Cascade<Real>::sum_targets(const SolverModel<Real>& model) noexcept {
  std::fill(own_.begin(), own_.end(), PointMoments<Real>{});
  for (const SolverPatch<Real>& patch : model.patches) {
    const PointMoments<Real> moments = moments_of(model, patch);
    own_[patch.joint].add_transformed(moments, RigidTransform<Real>{}, Real(1));
  }
}

// A patch on its own finger's plane needs no look at its points while none fades: its targets are linear in the displacements.
template <class Real>
PointMoments<Real> Cascade<Real>::moments_of(const SolverModel<Real>& model, const SolverPatch<Real>& patch) const noexcept {
  const PlaneDeformation<Real>& plane = planes[patch.finger];
  const Real least_delta_r = *std::min_element(plane.delta_r.begin(), plane.delta_r.begin() + plane.vectors);
  constexpr Real fading = Real(-0.5);
  if (model.options.field == FieldReading::finger && plane.default_angles && least_delta_r >= fading &&
      patch.least_rho + std::min(least_delta_r, Real(0)) >= Real(0)) {
    PointMoments<Real> moments = patch.rest;
    for (int j = 0; j < plane.vectors; ++j) moments.add_targets(patch.per_unit[plane.vectors - 1][j], plane.delta_r[j]);
    const Real turn = model.azimuth_sign * plane.delta_theta;
    moments.turn_targets(std::cos(turn), std::sin(turn));
    return moments;
  }
  PointMoments<Real> moments;
  for (std::size_t k = patch.first; k < patch.last; ++k) {
    const SolverPoint<Real>& point = model.points[k];
    const Target target = target_of(model, point);
    moments.add(point.weight, target.share, point.p, target.t);
  }
  return moments;
}

// moments from the tips inward: what each joint carries, with the joints further out at their present values
template <class Real>
void Cascade<Real>::carry_moments(const SolverModel<Real>& model, std::span<const ScopedJoint> scope) noexcept {
  for (const ScopedJoint& s : scope) carried_[s.joint] = own_[s.joint];
  for (std::size_t n = scope.size(); n-- > 0;) {
    if (!scope[n].inner) continue;
    const SolverJoint<Real>& joint = model.joints[scope[n].joint];
    carried_[joint.parent].add_transformed(carried_[scope[n].joint], T_parent_moved_[scope[n].joint],
                                           joint.master < 0 ? decay_ : Real(1));
  }
}

template <class Real>
RigidTransform<Real> Cascade<Real>::frame_before_motion(const SolverModel<Real>& model, int joint) const noexcept {
  const SolverJoint<Real>& j = model.joints[joint];
  return j.parent < 0 ? j.T_parent_joint : T_moved_[j.parent] * j.T_parent_joint;
}

template <class Real>
void Cascade<Real>::move_frames(const SolverModel<Real>& model, std::span<const ScopedJoint> scope) noexcept {
  for (const ScopedJoint& s : scope) {
    const int parent = model.joints[s.joint].parent;
    T_moved_[s.joint] = parent < 0 ? T_parent_moved_[s.joint] : T_moved_[parent] * T_parent_moved_[s.joint];
  }
}

// one pass: unknowns that move several fingers first, then every joint from the palm outward, parents final, children as they are
template <class Real>
void Cascade<Real>::sweep(const SolverModel<Real>& model) noexcept {
  carry_moments(model, model.whole_tree);
  for (const SolverStep& step : model.steps) {
    if (model.step_at[step.driven.front()] >= 0) continue;
    move_frames(model, model.whole_tree);
    solve_step(model, step);
    carry_moments(model, model.whole_tree);
  }
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    if (model.step_at[i] >= 0) solve_step(model, model.steps[model.step_at[i]]);
    T_moved_[i] = model.joints[i].parent < 0 ? T_parent_moved_[i] : T_moved_[model.joints[i].parent] * T_parent_moved_[i];
  }
}

template <class Real>
void Cascade<Real>::solve_step(const SolverModel<Real>& model, const SolverStep& step) noexcept {
  const SolverJoint<Real>& joint = model.joints[step.joint];
  Real full_weight = 0, weight = 0;
  for (int i : step.driven) full_weight += carried_[i].full_weight, weight += carried_[i].weight;
  Real open_share = full_weight > Real(0) ? weight / full_weight : Real(1);
  if (model.options.closing == Closing::hard && open_share > Real(0)) open_share = Real(1);
  open_share_[step.joint] = open_share;
  mark(step, closed, open_share <= Real(0));
  if (open_share <= Real(0)) return;

  const bool single = step.driven.size() == 1 && step.driven.front() == step.joint;
  JointValue<Real> value;
  if (model.options.rule == Rule::contact)
    value = joint.value(single ? contact_single(model, step) : contact_group(model, step));
  else
    value = single ? fit_single(model, step.joint) : joint.value(fit_group(model, step));
  mark(step, at_limit, value.q < joint.lower.q || value.q > joint.upper.q);
  set_unknown(model, step, value.q < joint.lower.q ? joint.lower : value.q > joint.upper.q ? joint.upper : value);
}

// Each joint goes to its closed end by the share of points that closing has taken. Only now: a child fitted to a parent
// that has faded already would open to make up for it (measured on Allegro: a jump of 1 rad at delta r = -0.76).
template <class Real>
void Cascade<Real>::close_faded(const SolverModel<Real>& model) noexcept {
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = values_[i].q;
  for (const SolverStep& step : model.steps) {
    const Real share = open_share_[step.joint];
    if (share == Real(1)) continue;
    const SolverJoint<Real>& joint = model.joints[step.joint];
    q[step.joint] = std::clamp(share * q[step.joint] + (Real(1) - share) * joint.q_closed, joint.lower.q, joint.upper.q);
    for (int i : step.driven)
      if (i != step.joint) q[i] = model.joints[i].multiplier * q[step.joint] + model.joints[i].offset;
  }
}

template <class Real>
void Cascade<Real>::mark(const SolverStep& step, std::vector<std::uint8_t>& flags, bool value) noexcept {
  flags[step.joint] = value;
  for (int i : step.driven) flags[i] = value;
}

// The angle of least squares in closed form: atan2 of the summed sines and cosines (design 3.8). A share of the points' own
// weight holds the joint at its present value: where the targets come close to the axis and the sums nearly cancel, the angle
// would otherwise spin through a half turn (measured on Shadow: 0.6 rad for 0.03 in delta r). At rest it changes nothing, and
// over several passes it fades, since it pulls to the pass before.
template <class Real>
JointValue<Real> Cascade<Real>::fit_single(const SolverModel<Real>& model, int joint) const noexcept {
  constexpr Real hold = Real(0.25), two_pi = 2 * std::numbers::pi_v<Real>;
  const SolverJoint<Real>& j = model.joints[joint];
  const PointMoments<Real>& moments = carried_[joint];
  const JointValue<Real>& present = values_[joint];
  if (!(moments.weight > Real(0))) return present;
  const JointFit<Real> fit = fit_joint(moments, frame_before_motion(model, joint));
  if (j.prismatic) return j.value(fit.shift / moments.weight);

  const Real held = hold * (moments.p.x * moments.p.x + moments.p.y * moments.p.y) / moments.weight;
  const Real sine = fit.sine + held * present.sine, cosine = fit.cosine + held * present.cosine;
  const Real length = std::sqrt(sine * sine + cosine * cosine);
  if (!(length > Real(0))) return present;
  const Real turn = std::atan2(sine, cosine) - j.branch_start;
  return {j.branch_start + (turn < Real(0) ? turn + two_pi : turn < two_pi ? turn : turn - two_pi), cosine / length, sine / length};
}

// Joints coupled by mimics have no closed form: follow the descent from the present value to the first minimum on the way.
template <class Real>
Real Cascade<Real>::fit_group(const SolverModel<Real>& model, const SolverStep& step) noexcept {
  constexpr int scan_steps = 12, refinements = 14;
  const SolverJoint<Real>& joint = model.joints[step.joint];
  const JointValue<Real> present = values_[step.joint];
  const Real start = present.q;
  Real before = start, slope_before = descent(model, step, start);
  if (slope_before == Real(0)) return start;  // at rest already, or no point to fit
  const Real end = slope_before > Real(0) ? joint.upper.q : joint.lower.q;
  Real found = end;
  for (int k = 1; k <= scan_steps; ++k) {
    Real after = start + (end - start) * Real(k) / Real(scan_steps);
    Real slope_after = descent(model, step, after);
    if ((slope_after > Real(0)) == (slope_before > Real(0))) {
      before = after, slope_before = slope_after;
      continue;
    }
    // a bracketed minimum: regula falsi, the stale end's slope halved (Illinois)
    int kept = 0;
    for (int n = 0; n < refinements && slope_before != slope_after; ++n) {
      found = before - slope_before * (after - before) / (slope_after - slope_before);
      const Real slope = descent(model, step, found);
      if ((slope > Real(0)) == (slope_after > Real(0))) {
        after = found, slope_after = slope;
        if (kept == 1) slope_before /= 2;
        kept = 1;
      } else {
        before = found, slope_before = slope;
        if (kept == -1) slope_after /= 2;
        kept = -1;
      }
    }
    break;
  }
  set_unknown(model, step, present);
  carry_moments(model, step.scope);
  return found;
}

// minus half the derivative of the weighted squared distance with respect to the group's unknown
template <class Real>
Real Cascade<Real>::descent(const SolverModel<Real>& model, const SolverStep& step, Real value) noexcept {
  set_unknown(model, step, model.joints[step.joint].value(value));
  carry_moments(model, step.scope);
  move_frames(model, step.scope);
  Real sum = 0;
  for (int i : step.driven) {
    const JointFit<Real> fit = fit_joint(carried_[i], T_moved_[i]);
    sum += (i == step.joint ? Real(1) : model.joints[i].multiplier) * (model.joints[i].prismatic ? fit.shift : fit.sine);
  }
  return sum;
}

// origin of the node's joint, or the fingertip, in `joint`'s frame with `joint` itself at zero
template <class Real>
Vector3<Real> Cascade<Real>::node_in_frame(const SolverModel<Real>& model, const ContactNode& node, int joint) const noexcept {
  int at = node.joint >= 0 ? node.joint : model.tip_joint[node.finger];
  Vector3<Real> p = node.joint >= 0 ? Vector3<Real>{} : model.p_tip[node.finger];
  while (at != joint && at >= 0) {
    const SolverJoint<Real>& j = model.joints[at];
    p = T_parent_moved_[at] * p;
    at = j.parent;
  }
  return p;
}

/// Signed distance of a point from the deformed profile of `plane`, sphere radii.
template <class Real>
Real gap_to_profile(const PlaneDeformation<Real>& plane, Vector3<Real> p) {
  const Real radius = norm(p);
  const Real phi = std::atan2(std::hypot(p.x, p.y), -p.z);
  return radius - std::max(Real(1) + plane.radial(phi), Real(0));
}

// turn from open until the node meets the profile of its finger's plane (design 3.8, rule `contact`)
template <class Real>
Real Cascade<Real>::contact_single(const SolverModel<Real>& model, const SolverStep& step) noexcept {
  const SolverJoint<Real>& joint = model.joints[step.joint];
  const RigidTransform<Real> T = frame_before_motion(model, step.joint);
  const auto path = [&](const ContactNode& node) {
    return Circle<Real>::about(T.rotation.column(2), T.translation, T * node_in_frame(model, node, step.joint));
  };
  if (!joint.prismatic && step.nodes.size() == 1) {
    const PlaneDeformation<Real>& plane = plane_of(model, step.nodes[0].finger);
    const Circle<Real> circle = path(step.nodes[0]);
    const bool undeformed = std::all_of(plane.delta_r.begin(), plane.delta_r.end(), [](Real d) { return d == Real(0); });
    if (undeformed) return first_contact_with_sphere(circle, joint.travel);
    return first_contact_by_scan<Real>([&](Real t) { return gap_to_profile(plane, circle.at(t)); }, joint.travel);
  }
  return contact_group(model, step);
}

// the same for coupled joints, several fingers and sliding joints: the nodes' mean gap decides
template <class Real>
Real Cascade<Real>::contact_group(const SolverModel<Real>& model, const SolverStep& step) noexcept {
  const JointValue<Real> present = values_[step.joint];
  const auto mean_gap = [&](Real value) {
    set_unknown(model, step, model.joints[step.joint].value(value));
    move_frames(model, step.scope);
    Real sum = 0;
    for (const ContactNode& node : step.nodes) {
      const Vector3<Real> p = node.joint >= 0 ? T_moved_[node.joint].translation
                                              : T_moved_[model.tip_joint[node.finger]] * model.p_tip[node.finger];
      sum += gap_to_profile(plane_of(model, node.finger), p);
    }
    return sum / Real(step.nodes.size());
  };
  const Real found = first_contact_by_scan<Real>(mean_gap, model.joints[step.joint].travel);
  set_unknown(model, step, present);
  return found;
}

template <class Real>
double Cascade<Real>::residual_rms(const SolverModel<Real>& model) noexcept {
  for (std::size_t i = 0; i < q.size(); ++i) set_joint(model, static_cast<int>(i), model.joints[i].value(q[i]));
  move_frames(model, model.whole_tree);
  double sum = 0, weight = 0;
  for (const SolverPoint<Real>& point : model.points) {
    const Target target = target_of(model, point);
    const Vector3<Real> error = T_moved_[point.joint] * point.p - target.t;
    const double w = double(point.weight) * double(target.share);
    sum += w * double(dot(error, error));
    weight += w;
  }
  return weight > 0 ? std::sqrt(sum / weight) : std::numeric_limits<double>::quiet_NaN();
}

template class Cascade<float>;
template class Cascade<double>;

}  // namespace uhas
