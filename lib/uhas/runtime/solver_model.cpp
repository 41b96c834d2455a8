#include "uhas/runtime/solver_model_detail.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <string>

#include "uhas/base/spherical.hpp"

namespace uhas {
namespace {

constexpr double kPi = std::numbers::pi;

template <class Real>
Vector3<Real> cast(Vector3d a) {
  return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
}

template <class Real>
RigidTransform<Real> cast(const RigidTransformd& T) {
  RigidTransform<Real> result;
  for (int i = 0; i < 9; ++i) result.rotation.m[i] = static_cast<Real>(T.rotation.m[i]);
  result.translation = cast<Real>(T.translation);
  return result;
}

/// The free arc outside the limits belongs partly to the open limit, the rest to the closed one: a target that passes behind
/// a closing joint must leave it closed, while one a little beyond open must leave it open (design 3.8).
double branch_start(const Joint& joint, double q_closed) {
  constexpr double share_of_open_side = 0.35;
  const double free_arc = std::max(2 * kPi - (joint.upper - joint.lower), 0.0);
  const bool closes_upward = joint.upper - q_closed <= q_closed - joint.lower;
  return closes_upward ? joint.lower - share_of_open_side * free_arc : joint.upper + share_of_open_side * free_arc - 2 * kPi;
}

/// Turns z to the joint's axis: the joint frame of the solver in the joint frame of the profile.
RigidTransformd axis_frame(const Joint& joint) {
  const Vector3d x = any_orthogonal(joint.axis);
  return {Rotationd::from_columns(x, cross(joint.axis, x), joint.axis), {}};
}

/// Frame of the profile's joint (or, for -1, of the palm) in the solver's joint (or S), metres.
RigidTransformd solver_from_profile(const HandProfile& profile, int joint) {
  return joint < 0 ? profile.T_palm_sphere.inverse() : axis_frame(profile.tree.joints[joint]).inverse();
}

template <class Real>
SolverJoint<Real> compile_joint(const HandProfile& profile, const SolveOptions& options, int index) {
  const Joint& joint = profile.tree.joints[index];
  const JointTraits& traits = profile.joint_traits[index];

  SolverJoint<Real> compiled;
  compiled.prismatic = joint.kind == JointKind::prismatic;
  compiled.parent = joint.parent;
  RigidTransformd T = solver_from_profile(profile, joint.parent) * joint.T_parent_joint * axis_frame(joint);
  T.translation = T.translation / profile.radius;
  compiled.T_parent_joint = cast<Real>(T);

  const double unit = compiled.prismatic ? profile.radius : 1.0;
  compiled.unit = static_cast<Real>(unit);
  compiled.lower = compiled.value(static_cast<Real>(joint.lower / unit));
  compiled.upper = compiled.value(static_cast<Real>(joint.upper / unit));
  const bool from_open = options.rule == Rule::contact && traits.joint_class == JointClass::encompassing;
  compiled.start = compiled.value(static_cast<Real>((from_open ? traits.q_open : traits.q_sphere) / unit));
  compiled.q_closed = static_cast<Real>(traits.q_closed / unit);
  const bool closes_upward = joint.upper - traits.q_closed <= traits.q_closed - joint.lower;
  compiled.travel = {static_cast<Real>(traits.q_open / unit), compiled.q_closed,
                     closes_upward ? compiled.lower.q : compiled.upper.q};
  compiled.branch_start = static_cast<Real>(branch_start(joint, traits.q_closed));
  compiled.master = joint.mimic_master;
  if (joint.mimic_master >= 0) {
    const double master_unit = profile.tree.joints[joint.mimic_master].kind == JointKind::prismatic ? profile.radius : 1.0;
    compiled.multiplier = static_cast<Real>(joint.mimic_multiplier * master_unit / unit);
    compiled.offset = static_cast<Real>(joint.mimic_offset / unit);
  }
  return compiled;
}

/// Fingers by azimuth of their planes; neighbours closer than 5 degrees share one plane (design 3.7).
std::vector<std::vector<int>> group_planes(const HandProfile& profile) {
  constexpr double same_plane = 5 * kPi / 180;
  std::vector<int> order(profile.fingers.size());
  std::iota(order.begin(), order.end(), 0);
  const auto theta = [&](int f) { return profile.fingers[f].theta_initial; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return theta(a) < theta(b); });

  std::vector<std::vector<int>> groups;
  for (int f : order) {
    if (!groups.empty() && theta(f) - theta(groups.back().back()) < same_plane)
      groups.back().push_back(f);
    else
      groups.push_back({f});
  }
  if (groups.size() > 1 && theta(groups.front().front()) + 2 * kPi - theta(groups.back().back()) < same_plane) {
    groups.front().insert(groups.front().end(), groups.back().begin(), groups.back().end());
    groups.pop_back();
  }
  return groups;
}

/// Mean azimuth of each group, on the circle.
std::vector<double> group_azimuths(const HandProfile& profile, const std::vector<std::vector<int>>& groups) {
  std::vector<double> azimuths;
  for (const std::vector<int>& group : groups) {
    double c = 0, s = 0;
    for (int f : group) c += std::cos(profile.fingers[f].theta_initial), s += std::sin(profile.fingers[f].theta_initial);
    azimuths.push_back(std::atan2(s, c));
  }
  return azimuths;
}

/// Where `theta` lies between the planes: the group before it, the group after it, and the share of the way.
template <class Real>
void locate_between_planes(double theta, const std::vector<double>& azimuths, SolverPoint<Real>& point) {
  const auto way = [](double from, double to) {
    const double angle = std::fmod(to - from, 2 * kPi);
    return angle < 0 ? angle + 2 * kPi : angle;
  };
  int before = 0, after = 0;
  for (int g = 0; g < static_cast<int>(azimuths.size()); ++g) {
    if (way(azimuths[g], theta) < way(azimuths[before], theta)) before = g;
    if (way(theta, azimuths[g]) < way(theta, azimuths[after])) after = g;
  }
  const double gap = way(azimuths[before], theta) + way(theta, azimuths[after]);
  point.plane_before = before;
  point.plane_after = after;
  point.blend = gap > 0 ? static_cast<Real>(way(azimuths[before], theta) / gap) : Real(0);
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

/// Sorts the points by joint and finger and sums up each patch.
template <class Real>
std::vector<SolverPatch<Real>> gather_patches(std::vector<SolverPoint<Real>>& points) {
  std::stable_sort(points.begin(), points.end(), [](const SolverPoint<Real>& a, const SolverPoint<Real>& b) {
    return std::pair(a.joint, a.finger) < std::pair(b.joint, b.finger);
  });
  std::vector<SolverPatch<Real>> patches;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const SolverPoint<Real>& point = points[k];
    if (patches.empty() || patches.back().joint != point.joint || patches.back().finger != point.finger) {
      patches.push_back({.joint = point.joint, .finger = point.finger, .first = k, .last = k, .least_rho = point.rho, .rest = {}, .per_unit = {}});
      for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) patches.back().per_unit[vectors - 1].resize(vectors);
    }
    SolverPatch<Real>& patch = patches.back();
    patch.last = k + 1;
    patch.least_rho = std::min(patch.least_rho, point.rho);
    patch.rest.add(point.weight, Real(1), point.p, point.rho * point.direction);
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) {
      for (int j = 0; j < vectors; ++j) {
        PlaneDeformation<Real> unit{.delta_theta = 0, .vectors = vectors, .default_angles = true, .phi = {}, .delta_r = {}};
        for (int i = 0; i < vectors; ++i) unit.phi[i] = default_driving_angle<Real>(vectors, i);
        unit.delta_r[j] = Real(1);
        patch.per_unit[vectors - 1][j].add(point.weight, Real(1), point.p, unit.radial(point.phi) * point.direction);
      }
    }
  }
  return patches;
}

}  // namespace

template <class Real>
SolverModel<Real>::SolverModel(const HandProfile& profile, const SolveOptions& solve_options)
    : options(solve_options), decoder(profile), azimuth_sign(profile.mirrored ? Real(-1) : Real(1)) {
  const int joint_count = static_cast<int>(profile.tree.joints.size());
  const int finger_count = static_cast<int>(profile.fingers.size());
  for (int i = 0; i < joint_count; ++i) {
    joints.push_back(compile_joint<Real>(profile, options, i));
    whole_tree.push_back({i, joints[i].parent >= 0});
  }

  std::vector<std::vector<int>> finger_joints;
  for (const ProfileFinger& finger : profile.fingers) finger_joints.push_back(finger.joints);
  std::vector<JointClass> classes;
  std::vector<double> q_sphere;
  for (const JointTraits& traits : profile.joint_traits) {
    classes.push_back(traits.joint_class);
    q_sphere.push_back(traits.q_sphere);
  }
  step_at.assign(joint_count, -1);
  for (const CascadeStep& step : plan_cascade(profile.tree, finger_joints, classes, q_sphere)) {
    if (step.driven.size() == 1 || step.fingers.size() == 1) step_at[step.driven.front()] = static_cast<int>(steps.size());
    steps.push_back({step, scope_of(step, profile.tree)});
  }

  for (const ProfileFinger& finger : profile.fingers) {
    const ProfileLink& link = profile.links[finger.tip_link];
    tip_joint.push_back(link.joint);
    p_tip.push_back(cast<Real>((solver_from_profile(profile, link.joint) * link.T_joint_link * finger.p_tip_link) / profile.radius));
  }

  for (int f = 0; f < finger_count; ++f) {
    if (profile.fingers[f].lateral_table < 0) continue;
    const LateralTable& table = profile.lateral_tables[profile.fingers[f].lateral_table];
    laterals.push_back({table.joint, f, static_cast<Real>(table.delta_theta_lower), static_cast<Real>(table.delta_theta_upper), {}});
    for (double q : table.inverse_q) laterals.back().inverse_q.push_back(static_cast<Real>(q) / joints[table.joint].unit);
  }

  plane_groups = group_planes(profile);
  group_of_finger.resize(finger_count);
  for (int g = 0; g < static_cast<int>(plane_groups.size()); ++g)
    for (int f : plane_groups[g]) group_of_finger[f] = g;
  const std::vector<double> azimuths = group_azimuths(profile, plane_groups);
  for (const Correspondence& c : profile.correspondences) {
    const ProfileLink& link = profile.links[c.link];
    SolverPoint<Real> point;
    point.joint = link.joint;
    point.finger = finger_of_point(profile, c);
    if (c.weight <= 0 || point.finger < 0) continue;
    point.p = cast<Real>((solver_from_profile(profile, link.joint) * link.T_joint_link * c.p_link) / profile.radius);
    const double azimuth = profile.mirrored ? -c.theta : c.theta;
    point.direction = cast<Real>(from_spherical<double>({azimuth, c.phi, 1.0}));
    point.rho = static_cast<Real>(c.rho);
    point.phi = static_cast<Real>(c.phi);
    point.weight = static_cast<Real>(c.weight);
    locate_between_planes(c.theta, azimuths, point);
    points.push_back(point);
  }
  patches = gather_patches(points);
}

template struct SolverModel<float>;
template struct SolverModel<double>;

}  // namespace uhas
