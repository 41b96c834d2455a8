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

template <class Real>
RigidTransform<Real> motion(const SolverJoint<Real>& joint, Real q) {
  if (joint.prismatic) return {{}, q * joint.axis};
  return {Rotation<Real>::about(joint.axis, q), {}};
}

}  // namespace

template <class Real>
Cascade<Real>::Cascade(const SolverModel<Real>& model)
    : planes(model.tip_joint.size()),
      q(model.joints.size()),
      at_limit(model.joints.size()),
      closed(model.joints.size()),
      group_planes_(model.plane_groups.size()),
      targets_(model.points.size()),
      T_moved_(model.joints.size()),
      own_(model.joints.size()),
      carried_(model.joints.size()),
      open_share_(model.joints.size()) {}

template <class Real>
void Cascade<Real>::run(const SolverModel<Real>& model) noexcept {
  average_planes(model);
  begin_joints(model);
  place_targets(model);
  const int passes = model.options.rule == Rule::contact ? 1 : model.options.passes;
  for (int pass = 0; pass < passes; ++pass) {
    // the decay rises to 1 over the passes: the last ones descend on the plain weights
    const double progress = passes > 1 ? double(pass) / double(passes - 1) : 0.0;
    decay_ = static_cast<Real>(std::pow(kDecay, 1.0 - progress));
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

// joint values before the cascade: lateral joints by table, all others where the rule starts from
template <class Real>
void Cascade<Real>::begin_joints(const SolverModel<Real>& model) noexcept {
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = model.joints[i].q_start;
  for (const SolverLateral<Real>& lateral : model.laterals)
    q[lateral.joint] = look_up_lateral<Real>(lateral.inverse_q, lateral.lower, lateral.upper,
                                             plane_of(model, lateral.finger).delta_theta);
  for (std::size_t i = 0; i < q.size(); ++i) {
    const SolverJoint<Real>& joint = model.joints[i];
    if (joint.master >= 0) q[i] = joint.multiplier * q[joint.master] + joint.offset;
  }
  std::fill(at_limit.begin(), at_limit.end(), std::uint8_t{0});
  std::fill(closed.begin(), closed.end(), std::uint8_t{0});
}

// every point's target on the deformed sphere, and the moments of each link's points (design 3.7)
template <class Real>
void Cascade<Real>::place_targets(const SolverModel<Real>& model) noexcept {
  std::fill(own_.begin(), own_.end(), PointMoments<Real>{});
  const bool field = model.options.field == FieldReading::field;
  int turned_finger = -1;
  Real c = 1, s = 0;
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    const SolverPoint<Real>& point = model.points[k];
    const PlaneDeformation<Real>& before = field ? group_planes_[point.plane_before] : planes[point.finger];
    const PlaneDeformation<Real>& after = field ? group_planes_[point.plane_after] : before;
    const auto between = [&](Real a, Real b) { return field ? a + point.blend * (b - a) : a; };
    const auto radial = [&](Real phi) { return field ? between(before.radial(phi), after.radial(phi)) : before.radial(phi); };

    // the points of a finger turn together, those of the field each by its own angle
    if (field || turned_finger != point.finger) {
      const Real turn = model.azimuth_sign * between(before.delta_theta, after.delta_theta);
      c = std::cos(turn), s = std::sin(turn);
      turned_finger = point.finger;
    }
    const Real delta_r = radial(point.phi);
    Real share;
    if (model.options.closing == Closing::hard) {
      share = Real(1) + delta_r < Real(0) ? Real(0) : Real(1);
    } else {
      // the anchored pole must not keep a root open, so short of the first driving vector that one decides
      const Real first_phi = between(before.phi[0], after.phi[0]);
      const Real u = std::clamp((Real(1) + (point.phi < first_phi ? radial(first_phi) : delta_r)) * Real(2), Real(0), Real(1));
      share = u * u * (Real(3) - Real(2) * u);
    }
    const Real radius = std::max(point.rho + delta_r, Real(0));
    const Vector3<Real> n = point.direction;
    targets_[k] = {radius * Vector3<Real>{c * n.x - s * n.y, s * n.x + c * n.y, n.z}, share};
    own_[point.joint].add(point.weight, share, point.p, targets_[k].t);
  }
}

// moments from the tips inward: what each joint carries, with the joints further out at their present values
template <class Real>
void Cascade<Real>::carry_moments(const SolverModel<Real>& model, std::span<const ScopedJoint> scope) noexcept {
  for (const ScopedJoint& s : scope) carried_[s.joint] = own_[s.joint];
  for (std::size_t n = scope.size(); n-- > 0;) {
    if (!scope[n].inner) continue;
    const SolverJoint<Real>& joint = model.joints[scope[n].joint];
    carried_[joint.parent].add_transformed(carried_[scope[n].joint], joint.T_parent_joint * motion(joint, q[scope[n].joint]),
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
  for (const ScopedJoint& s : scope)
    T_moved_[s.joint] = frame_before_motion(model, s.joint) * motion(model.joints[s.joint], q[s.joint]);
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
    T_moved_[i] = frame_before_motion(model, i) * motion(model.joints[i], q[i]);
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
  const Real fitted = model.options.rule == Rule::contact ? (single ? contact_single(model, step) : contact_group(model, step))
                                                          : (single ? fit_single(model, step.joint) : fit_group(model, step));
  const Real held = std::clamp(fitted, joint.lower, joint.upper);
  mark(step, at_limit, held != fitted);
  set_unknown(model, step, held);
}

// Each joint goes to its closed end by the share of points that closing has taken. Only now: a child fitted to a parent
// that has faded already would open to make up for it (measured on Allegro: a jump of 1 rad at delta r = -0.76).
template <class Real>
void Cascade<Real>::close_faded(const SolverModel<Real>& model) noexcept {
  for (const SolverStep& step : model.steps) {
    const SolverJoint<Real>& joint = model.joints[step.joint];
    const Real share = open_share_[step.joint];
    set_unknown(model, step, std::clamp(share * q[step.joint] + (Real(1) - share) * joint.q_closed, joint.lower, joint.upper));
  }
}

template <class Real>
void Cascade<Real>::set_unknown(const SolverModel<Real>& model, const SolverStep& step, Real value) noexcept {
  q[step.joint] = value;
  for (int i : step.driven)
    if (i != step.joint) q[i] = model.joints[i].multiplier * value + model.joints[i].offset;
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
Real Cascade<Real>::fit_single(const SolverModel<Real>& model, int joint) const noexcept {
  constexpr Real hold = Real(0.25);
  const SolverJoint<Real>& j = model.joints[joint];
  const PointMoments<Real>& moments = carried_[joint];
  if (!(moments.weight > Real(0))) return q[joint];
  const JointFit<Real> fit = fit_joint(moments, frame_before_motion(model, joint), j.axis);
  if (j.prismatic) return fit.shift / moments.weight;

  const Vector3<Real> arm = orthogonal_part(moments.p, j.axis);
  const Real held = hold * dot(arm, arm) / moments.weight;
  const Real sine = fit.sine + held * std::sin(q[joint]), cosine = fit.cosine + held * std::cos(q[joint]);
  if (sine == Real(0) && cosine == Real(0)) return q[joint];
  constexpr Real two_pi = 2 * std::numbers::pi_v<Real>;
  const Real turn = std::atan2(sine, cosine) - j.branch_start;
  return j.branch_start + turn - two_pi * std::floor(turn / two_pi);
}

// Joints coupled by mimics have no closed form: follow the descent from the present value to the first minimum on the way.
template <class Real>
Real Cascade<Real>::fit_group(const SolverModel<Real>& model, const SolverStep& step) noexcept {
  constexpr int scan_steps = 12, refinements = 14;
  const SolverJoint<Real>& joint = model.joints[step.joint];
  const Real start = q[step.joint];
  Real before = start, slope_before = descent(model, step, start);
  if (slope_before == Real(0)) return start;  // at rest already, or no point to fit
  const Real end = slope_before > Real(0) ? joint.upper : joint.lower;
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
  set_unknown(model, step, start);
  carry_moments(model, step.scope);
  return found;
}

// minus half the derivative of the weighted squared distance with respect to the group's unknown
template <class Real>
Real Cascade<Real>::descent(const SolverModel<Real>& model, const SolverStep& step, Real value) noexcept {
  set_unknown(model, step, value);
  carry_moments(model, step.scope);
  move_frames(model, step.scope);
  Real sum = 0;
  for (int i : step.driven) {
    const JointFit<Real> fit = fit_joint(carried_[i], T_moved_[i], model.joints[i].axis);
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
    p = j.T_parent_joint * (motion(j, q[at]) * p);
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
    const Vector3<Real> axis = T.rotation * joint.axis;
    return Circle<Real>::about(axis, T.translation, T * node_in_frame(model, node, step.joint));
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
  const Real start = q[step.joint];
  const auto mean_gap = [&](Real value) {
    set_unknown(model, step, value);
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
  set_unknown(model, step, start);
  return found;
}

template <class Real>
double Cascade<Real>::residual_rms(const SolverModel<Real>& model) noexcept {
  move_frames(model, model.whole_tree);
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    const SolverPoint<Real>& point = model.points[k];
    const Vector3<Real> error = T_moved_[point.joint] * point.p - targets_[k].t;
    const double w = double(point.weight) * double(targets_[k].share);
    sum += w * double(dot(error, error));
    weight += w;
  }
  return weight > 0 ? std::sqrt(sum / weight) : std::numeric_limits<double>::quiet_NaN();
}

template class Cascade<float>;
template class Cascade<double>;

}  // namespace uhas
