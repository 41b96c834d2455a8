#include "uhas/runtime/cascade/solver_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <tuple>

#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/axis_frame.hpp"
#include "uhas/runtime/cascade/action_decoder.hpp"
#include "uhas/runtime/cascade/lead.hpp"

namespace uhas {
namespace {

constexpr double kPi = std::numbers::pi;

/// Factor on a point's weight for each unknown between it and the joint being solved, in a single pass
/// (docs/method.md#decay).
constexpr double kDecay = 0.5;

/// The joint frame of the solver, whose z is the axis, in the joint frame of the profile.
RigidTransformd solver_frame(const Joint& joint) { return {axis_frame(joint), {}}; }

/// Frame of the profile's joint (or, for -1, of the palm) in the solver's joint (or S), metres.
RigidTransformd solver_from_profile(const HandProfile& profile, int joint) {
  return joint < 0 ? profile.T_palm_sphere.inverse() : solver_frame(profile.tree.joints[joint]).inverse();
}

template <class Real>
SolverJoint<Real> compile_solver_joint(const HandProfile& profile, const SolveOptions& options, int index) {
  const Joint& joint = profile.tree.joints[index];
  const JointTraits& traits = profile.joint_traits[index];

  SolverJoint<Real> compiled;
  static_cast<CompiledJoint<Real>&>(compiled) =
      compile_joint(profile.tree, index, profile.T_palm_sphere.inverse(), {profile.radius, profile.radius})
          .cast<Real>();

  const double unit = compiled.prismatic ? profile.radius : 1.0;
  const auto value = [&](double q) {  // by libm: not in haste
    const JointValue<double> turn{q / unit, std::cos(q), std::sin(q)};
    return compiled.prismatic ? JointValue<Real>{Real(q / unit), 1, 0} : turn.cast<Real>();
  };
  compiled.unit = static_cast<Real>(unit);
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  compiled.least = static_cast<Real>(joint.mimic_master < 0 ? joint.lower : -unbounded);
  compiled.greatest = static_cast<Real>(joint.mimic_master < 0 ? joint.upper : unbounded);
  compiled.lower = value(joint.lower);
  compiled.upper = value(joint.upper);
  const bool from_open = options.rule == CascadeRule::contact && traits.joint_class == JointClass::encompassing;
  compiled.start = value(from_open ? traits.q_open : traits.q_sphere);
  compiled.q_closed = static_cast<Real>(traits.q_closed / unit);
  compiled.travel = travel_of(joint, traits.q_open, traits.q_closed).in_units_of<Real>(unit);
  return compiled;
}

/// The joints of `step.driven` and all further out, in tree order.
std::vector<ScopedJoint> scope_of(const CascadeStep& step, const KinematicTree& tree) {
  std::vector<bool> inside(tree.joints.size(), false);
  std::vector<ScopedJoint> scope;
  for (int i = 0; i < static_cast<int>(tree.joints.size()); ++i) {
    const int parent = tree.joints[i].parent;
    const bool inner = parent >= 0 && inside[parent];
    inside[i] = inner || std::find(step.driven.begin(), step.driven.end(), i) != step.driven.end();
    if (inside[i]) scope.push_back({i, inner});
  }
  return scope;
}

/// [joint] whether some step moves it.
std::vector<bool> moved_joints(std::span<const SolverStep> steps, std::size_t joint_count) {
  std::vector<bool> moved(joint_count, false);
  for (const SolverStep& step : steps)
    for (const ScopedJoint& s : step.scope) moved[s.joint] = true;
  return moved;
}

/// The finger whose plane a point follows: of those that share the joint, the one nearest in azimuth.
int finger_of_point(const HandProfile& profile, const Correspondence& c) {
  int nearest = -1;
  const auto distance = [&](int f) { return std::abs(wrap_angle(c.theta - profile.fingers[f].theta_initial)); };
  for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f) {
    const std::vector<int>& joints = profile.fingers[f].joints;
    if (std::find(joints.begin(), joints.end(), profile.links[c.link].joint) == joints.end()) continue;
    if (nearest < 0 || distance(f) < distance(nearest)) nearest = f;
  }
  return nearest;
}

/// Pairs of driven turning joints of which the first carries the second.
std::vector<std::pair<int, int>> nested_joints(const CascadeStep& step, const KinematicTree& tree) {
  std::vector<std::pair<int, int>> nested;
  const auto turns = [&](int i) { return tree.joints[i].kind != JointKind::prismatic; };
  for (int outer : step.driven)
    for (int inner = tree.joints[outer].parent; inner >= 0; inner = tree.joints[inner].parent)
      if (turns(inner) && turns(outer) && std::find(step.driven.begin(), step.driven.end(), inner) != step.driven.end())
        nested.emplace_back(inner, outer);
  return nested;
}

template <class Real>
PointColumns<Real> columns_of(std::span<const SolverPoint<Real>> points) {
  PointColumns<Real> columns;
  constexpr std::size_t widest = PointColumns<Real>::kWidest;
  columns.length = (points.size() + widest - 1) / widest * widest;
  const auto fill = [&](std::vector<Real>& column, const auto& number) {
    for (const SolverPoint<Real>& point : points) column.push_back(number(point));
    column.resize(columns.length);
  };
  using Point = SolverPoint<Real>;
  fill(columns.phi, [](const Point& point) { return point.phi; });
  fill(columns.rho, [](const Point& point) { return point.rho; });
  fill(columns.weight, [](const Point& point) { return point.weight; });
  fill(columns.p[0], [](const Point& point) { return point.p.x; });
  fill(columns.p[1], [](const Point& point) { return point.p.y; });
  fill(columns.p[2], [](const Point& point) { return point.p.z; });
  fill(columns.direction[0], [](const Point& point) { return point.direction.x; });
  fill(columns.direction[1], [](const Point& point) { return point.direction.y; });
  fill(columns.direction[2], [](const Point& point) { return point.direction.z; });
  return columns;
}

/// Sums up points [first, last), which are sorted by polar angle.
template <class Real>
SolverPatch<Real> compile_patch(const std::vector<SolverPoint<Real>>& points, std::size_t first, std::size_t last) {
  SolverPatch<Real> patch{.joint = points[first].joint,
                          .finger = points[first].finger,
                          .first = first,
                          .last = last,
                          .first_of_joint = first == 0 || points[first - 1].joint != points[first].joint,
                          .least_phi = points[first].phi,
                          .greatest_phi = points[last - 1].phi,
                          .least_rho = points[first].rho,
                          .rest = {},
                          .beyond = std::vector<TargetMoments<Real>>(last - first),
                          .beyond_phi = std::vector<TargetMoments<Real>>(last - first),
                          .columns = columns_of(std::span(points).subspan(first, last - first))};
  TargetMoments<Real> beyond, beyond_phi;
  for (std::size_t k = last; k-- > first;) {
    const SolverPoint<Real>& point = points[k];
    patch.least_rho = std::min(patch.least_rho, point.rho);
    patch.rest.add(point.weight, Real(1), point.p, point.rho * point.direction);
    beyond.add_pair(point.p, point.weight * point.direction);
    beyond_phi.add_pair(point.p, point.weight * point.phi * point.direction);
    patch.beyond[k - first] = beyond;
    patch.beyond_phi[k - first] = beyond_phi;
  }
  return patch;
}

/// Sorts the points by joint, finger and polar angle and sums up each patch.
template <class Real>
std::vector<SolverPatch<Real>> gather_patches(std::vector<SolverPoint<Real>>& points) {
  std::stable_sort(points.begin(), points.end(), [](const SolverPoint<Real>& a, const SolverPoint<Real>& b) {
    return std::tuple(a.joint, a.finger, a.phi) < std::tuple(b.joint, b.finger, b.phi);
  });
  std::vector<SolverPatch<Real>> patches;
  for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
    while (last < points.size() && points[last].joint == points[first].joint &&
           points[last].finger == points[first].finger)
      ++last;
    patches.push_back(compile_patch(points, first, last));
  }
  return patches;
}

/// For each joint the least joint that it cannot be solved without: they share a parent, a master or a finger.
std::vector<int> connected_joints(const HandProfile& profile) {
  const std::vector<Joint>& joints = profile.tree.joints;
  std::vector<int> least(joints.size());
  std::iota(least.begin(), least.end(), 0);
  const auto join = [&](int a, int b) {
    const auto [low, high] = std::minmax(least[a], least[b]);
    std::replace(least.begin(), least.end(), high, low);
  };
  for (int i = 0; i < static_cast<int>(joints.size()); ++i) {
    if (joints[i].parent >= 0) join(i, joints[i].parent);
    if (joints[i].mimic_master >= 0) join(i, joints[i].mimic_master);
  }
  for (const ProfileFinger& finger : profile.fingers)
    for (int i : finger.joints) join(i, finger.joints.front());
  return least;
}

template <class Real>
std::vector<SolverPart> gather_parts(const HandProfile& profile, const SolverModel<Real>& model,
                                     const std::vector<bool>& moved) {
  const std::vector<int> least = connected_joints(profile);
  std::vector<SolverPart> parts;
  for (int first = 0; first < static_cast<int>(least.size()); ++first) {
    if (least[first] != first) continue;
    SolverPart part;
    const auto inside = [&](int joint) { return least[joint] == first; };
    for (int i = 0; i < static_cast<int>(least.size()); ++i)
      if (inside(i)) part.tree.push_back({i, model.joints[i].parent >= 0 && moved[model.joints[i].parent]});
    for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f)
      if (inside(profile.fingers[f].joints.front())) part.fingers.push_back(f);
    for (int k = 0; k < static_cast<int>(model.laterals.size()); ++k) {
      if (!inside(model.laterals[k].joint)) continue;
      part.laterals.push_back(k);
      for (const ScopedJoint& s : part.tree)
        if (model.joints[s.joint].mimics(model.laterals[k].joint)) part.lateral_followers.push_back(s.joint);
    }
    for (int k = 0; k < static_cast<int>(model.steps.size()); ++k)
      if (inside(model.steps[k].driven.front())) part.steps.push_back(k);
    parts.push_back(part);
  }
  return parts;
}

}  // namespace

template <class Real>
SolverModel<Real>::SolverModel(const HandProfile& profile, const SolveOptions& solve_options)
    : options(solve_options),
      decoder(profile, solve_options.convention),
      azimuth_sign(profile.mirrored ? Real(-1) : Real(1)),
      plane_groups(group_planes(profile)) {
  const int joint_count = static_cast<int>(profile.tree.joints.size());
  const int finger_count = static_cast<int>(profile.fingers.size());
  for (int i = 0; i < joint_count; ++i) {
    joints.push_back(compile_solver_joint<Real>(profile, options, i));
  }

  // the decay rises to 1 over the passes: the last ones descend on the plain weights
  const int pass_count = options.rule == CascadeRule::contact ? 1 : options.passes;
  for (int pass = 0; pass < pass_count; ++pass) {
    const double done = pass_count > 1 ? double(pass) / double(pass_count - 1) : 0;
    passes.push_back({.decay = static_cast<Real>(std::pow(kDecay, 1 - done)), .first = pass == 0});
  }

  std::vector<std::vector<int>> finger_joints;
  for (const ProfileFinger& finger : profile.fingers) finger_joints.push_back(finger.joints);
  std::vector<JointClass> classes;
  std::vector<double> q_open;  // the pose that the wrap plans at: its nodes and the solver's are the same
  for (const JointTraits& traits : profile.joint_traits) {
    classes.push_back(traits.joint_class);
    q_open.push_back(traits.q_open);
  }
  step_at.assign(joint_count, -1);
  for (const CascadeStep& step : plan_cascade(profile.tree, finger_joints, classes, q_open)) {
    if (step.driven.size() == 1 || step.fingers.size() == 1)
      step_at[step.driven.front()] = static_cast<int>(steps.size());
    const bool single = step.driven.size() == 1 && step.driven.front() == step.joint;
    steps.push_back(
        {step, step.fingers.front(), single, nested_joints(step, profile.tree), scope_of(step, profile.tree)});
  }

  for (const ProfileFinger& finger : profile.fingers) {
    const ProfileLink& link = profile.links[finger.tip_link];
    tip_joint.push_back(link.joint);
    const Vector3d p = solver_from_profile(profile, link.joint) * link.T_joint_link * finger.p_tip_link;
    p_tip.push_back((p / profile.radius).cast<Real>());
  }

  for (int f = 0; f < finger_count; ++f) {
    if (profile.fingers[f].lateral_table < 0) continue;
    const LateralTable& table = profile.lateral_tables[profile.fingers[f].lateral_table];
    laterals.push_back(
        {table.joint, f, static_cast<Real>(table.delta_theta_lower), static_cast<Real>(table.delta_theta_upper), {}});
    for (double q : table.inverse_q)
      laterals.back().inverse_q.push_back(static_cast<Real>(q) / joints[table.joint].unit);
  }

  for (int i = 0; i < joint_count; ++i) {
    SolverJoint<Real>& joint = joints[i];
    if (joint.follows) joint.start = joint.value(joint.motion_at(joints[joint.source].start.q));
    joint.decayed_T_parent_start =
        scaled(joint.moved(joint.T_parent_joint, joint.start), joint.decay_inward(passes.front().decay));
  }

  group_of_finger.resize(finger_count);
  for (int g = 0; g < static_cast<int>(plane_groups.fingers.size()); ++g)
    for (int f : plane_groups.fingers[g]) group_of_finger[f] = g;
  for (const Correspondence& c : profile.correspondences) {
    const ProfileLink& link = profile.links[c.link];
    SolverPoint<Real> point;
    point.joint = link.joint;
    point.finger = finger_of_point(profile, c);
    if (c.weight <= 0 || point.finger < 0) continue;
    const Vector3d p = solver_from_profile(profile, link.joint) * link.T_joint_link * c.p_link;
    point.p = (p / profile.radius).cast<Real>();
    const double azimuth = profile.mirrored ? -c.theta : c.theta;
    point.direction = from_spherical<double>({azimuth, c.phi, 1.0}).cast<Real>();
    point.rho = static_cast<Real>(c.rho);
    point.phi = static_cast<Real>(c.phi);
    point.weight = static_cast<Real>(c.weight);
    const BetweenPlanes place = locate_between_planes(c.theta, plane_groups.azimuths);
    point.plane_before = place.before;
    point.plane_after = place.after;
    point.blend = static_cast<Real>(place.blend);
    points.push_back(point);
  }
  patches = gather_patches(points);
  patches_of_finger.resize(finger_count);
  const std::vector<bool> moved = moved_joints(steps, joints.size());
  for (int k = 0; k < static_cast<int>(patches.size()); ++k)
    if (moved[patches[k].joint]) patches_of_finger[patches[k].finger].push_back(k);
  parts = gather_parts(profile, *this, moved);
  set_leads(*this);
}

template <class Real>
std::shared_ptr<const SolverModel<Real>> compile_solver_model(const HandProfile& profile, const SolveOptions& options) {
  constexpr int max_passes = 100;
  if (options.passes < 1 || options.passes > max_passes)
    throw Error(ErrorCode::invalid_action, "", "passes is " + std::to_string(options.passes),
                "choose a number from 1 to 100");
  const ActionConvention& convention = options.convention;
  const auto bounded = [](double low, double x, double high) { return x >= low && x <= high; };
  if (std::abs(convention.azimuth_sign) != 1 || !bounded(-kMostRadialBound, convention.radial_lower, 0) ||
      !bounded(0, convention.radial_upper, kMostRadialBound))
    throw Error(ErrorCode::invalid_action, "",
                "the action convention has an azimuth sign or radial bounds out of range",
                "choose a sign of 1 or -1 and bounds lower <= 0 <= upper");
  validate_profile(profile, "");
  return std::make_shared<const SolverModel<Real>>(profile, options);
}

template std::shared_ptr<const SolverModel<float>> compile_solver_model<float>(const HandProfile&, const SolveOptions&);
template std::shared_ptr<const SolverModel<double>> compile_solver_model<double>(const HandProfile&,
                                                                                 const SolveOptions&);
template struct SolverModel<float>;
template struct SolverModel<double>;

}  // namespace uhas
