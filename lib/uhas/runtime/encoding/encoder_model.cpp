#include "uhas/runtime/encoding/encoder_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/kinematics/finger_groups.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/kinematics/mimics.hpp"
#include "uhas/runtime/encoding/damped_least_squares.hpp"

namespace uhas {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// Fingers that share a joint are sought together; in the reading `field` all are, for each point follows two planes.
std::vector<std::vector<int>> fingers_sought_together(const HandProfile& profile, FieldReading field) {
  std::vector<std::vector<int>> joints;
  for (const ProfileFinger& finger : profile.fingers) joints.push_back(independent_joints(profile.tree, finger.joints));
  if (field == FieldReading::finger) return group_fingers(joints);
  std::vector<int> all;
  for (int f = static_cast<int>(joints.size()); f-- > 0;) all.push_back(f);
  return {all};
}

/// The joints and the unknowns of each group, displacements before azimuths: a descent that moves the displacements
/// alone takes the first of them.
std::vector<FingerGroup> compile_groups(const HandProfile& profile, FieldReading field, int vectors) {
  std::vector<FingerGroup> groups;
  for (std::vector<int>& fingers : fingers_sought_together(profile, field)) {
    FingerGroup group;
    std::vector<int> joints;
    for (int f : fingers)
      joints.insert(joints.end(), profile.fingers[f].joints.begin(), profile.fingers[f].joints.end());
    group.joints = independent_joints(profile.tree, joints);
    for (int f : fingers)
      for (int j = 1; j <= vectors; ++j) group.unknowns.push_back({f, j});
    group.displacements = static_cast<int>(group.unknowns.size());
    for (int f : fingers)
      if (profile.fingers[f].lateral_table >= 0) group.unknowns.push_back({f, 0});
    group.fingers = std::move(fingers);
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Hat functions of V driving vectors at phi_j = pi j / (V + 1): all 0 at the anchored pole, constant beyond the last,
/// linear between (docs/method.md#driving-planes).
std::array<double, kMaxDrivingVectors> hats_at(double phi, int vectors) {
  const double position = std::min(phi * (vectors + 1) / std::numbers::pi, double(vectors));  // j at driving vector j
  std::array<double, kMaxDrivingVectors> hat{};
  for (int j = 1; j <= vectors; ++j) hat[j - 1] = std::max(1 - std::abs(position - j), 0.0);
  return hat;
}

EncoderFinger compile_finger(const HandProfile& profile, const ProfileFinger& finger, int vectors) {
  EncoderFinger compiled{.slots = finger.slots, .lateral_table = finger.lateral_table, .points = {}};

  // bounds of its numbers; delta theta stays 0 without a table
  for (int j = 1; j <= vectors; ++j) compiled.lower[j] = -kRadialBound, compiled.upper[j] = kRadialBound;
  if (finger.lateral_table >= 0) {
    const LateralTable& table = profile.lateral_tables[finger.lateral_table];
    compiled.lower[0] = table.delta_theta_lower, compiled.upper[0] = table.delta_theta_upper;
  }

  // weighted points on its links
  for (const Correspondence& c : profile.correspondences) {
    const ProfileLink& link = profile.links[c.link];
    if (c.weight <= 0 || !contains(finger.joints, link.joint)) continue;
    compiled.points.push_back({.joint = link.joint,
                               .p_joint = link.T_joint_link * c.p_link,
                               .rho = c.rho,
                               .weight = c.weight,
                               .hat = hats_at(c.phi, vectors)});
  }
  return compiled;
}

}  // namespace

EncoderModel::EncoderModel(const HandProfile& profile, const SolveOptions& options, int vectors)
    : driving_vectors(vectors),
      radius(profile.radius),
      center_palm(profile.T_palm_sphere.translation),
      tree(profile.tree),
      lateral_tables(profile.lateral_tables),
      groups(compile_groups(profile, options.field, vectors)) {
  for (const Joint& joint : tree.joints) unit.push_back(joint.kind == JointKind::prismatic ? radius : 1.0);
  for (const ProfileFinger& finger : profile.fingers) fingers.push_back(compile_finger(profile, finger, vectors));
}

void EncoderModel::start(std::span<const double> q, std::span<RigidTransformd> T_palm_joint,
                         std::span<FingerAction> actions) const noexcept {
  forward_kinematics(tree, q, T_palm_joint);
  for (std::size_t f = 0; f < fingers.size(); ++f) {
    const EncoderFinger& finger = fingers[f];

    // delta r: each point should stand at its rest radius plus what the driving vectors add at its polar angle
    DampedLeastSquares<kMaxDrivingVectors> displacements(driving_vectors);
    double total_weight = 0;
    for (const EncoderPoint& point : finger.points) {
      const double distance = norm(T_palm_joint[point.joint] * point.p_joint - center_palm) / radius;
      displacements.add(point.hat, distance - point.rho, point.weight);
      total_weight += point.weight;
    }
    // the damping decides only where no point feels a driving vector: it stays at rest
    constexpr double damping = 1e-3;
    const auto delta_r = displacements.solve(damping * std::max(total_weight, 1.0));

    FingerAction& action = actions[f];
    action = {};
    for (int j = 1; j <= driving_vectors; ++j) action[j] = std::clamp(delta_r[j - 1], finger.lower[j], finger.upper[j]);

    // delta theta: where the lateral joint stands in its table
    if (finger.lateral_table < 0) continue;
    const LateralTable& table = lateral_tables[finger.lateral_table];
    action[0] =
        look_up_delta_theta<double>(table.inverse_q, table.delta_theta_lower, table.delta_theta_upper, q[table.joint]);
  }
}

HandProfile with_wider_limits(HandProfile profile) {
  constexpr double widening = 0.7;  // rad, or sphere radii for a sliding joint
  for (std::size_t i = 0; i < profile.tree.joints.size(); ++i) {
    if (profile.joint_traits[i].joint_class != JointClass::encompassing) continue;
    Joint& joint = profile.tree.joints[i];

    // a turn gets no more than half of what is left of the circle on either side
    const double free_arc = std::max(2 * std::numbers::pi - (joint.upper - joint.lower), 0.0);
    const double wider =
        joint.kind == JointKind::prismatic ? widening * profile.radius : std::min(widening, free_arc / 2);
    joint.lower -= wider;
    joint.upper += wider;
  }
  return profile;
}

}  // namespace uhas
