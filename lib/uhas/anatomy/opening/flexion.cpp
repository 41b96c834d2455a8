#include "uhas/anatomy/opening/flexion.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/anatomy/opening/preferred_value.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// A joint turns the tip when the tip is this part of the finger's length off its axis.
constexpr double kShortestArm = 0.1;
/// Flexion joints turn up to this far (rad); what a joint turns beyond that rolls the finger.
constexpr double kWidestFlexion = 2;
/// Flexion axes are parallel within 30 degrees: side joints between them stand at mid range, which need not be neutral.
constexpr double kParallel = 0.866;
/// What straightens a phalanx to a tolerance of its reach is no further from straight than this (rad): short phalanges
/// bend far before they cost reach.
constexpr double kStraightAngle = 0.15;
/// A zero this far outside the limits still counts as their end (rad).
constexpr double kZeroSlack = 0.02;

}  // namespace

FlexionJoints find_flexion_joints(const KinematicTree& tree, const FingerSkeleton& finger) {
  const auto joint_at = [&](int position) -> const Joint& { return tree.joints[finger.joints[position]]; };
  const auto is_prismatic = [&](int position) { return joint_at(position).kind == JointKind::prismatic; };

  // a finger that ends in a slide is a jaw
  const int count = static_cast<int>(finger.joints.size());
  if (is_prismatic(count - 1)) return {{count - 1}, true};

  // a joint bends the finger when the tip is well off its axis
  const FingerPose pose = pose_finger(tree, finger, mid_pose(tree));
  const double length = finger_length(tree, finger);
  const auto bends = [&](int position) {
    const Vector3d arm = cross(pose.axis[position], pose.tip - pose.origin[position]);
    return !is_prismatic(position) && norm(arm) >= kShortestArm * length;
  };

  // the joints parallel to each one, and by how much they bend the finger together: a sum of squares, for one wide
  // joint bends a finger rather than two narrow ones; of equals those that hold the outer joint
  FlexionJoints flexion;
  double most = -1;
  for (int reference = count - 1; reference >= 0; --reference) {
    std::vector<int> parallel;
    double turn = 0;
    for (int i = 0; i < count; ++i) {
      if (is_prismatic(i) || std::abs(dot(pose.axis[i], pose.axis[reference])) <= kParallel) continue;
      parallel.push_back(i);
      if (bends(i)) turn += std::pow(std::min(joint_at(i).upper - joint_at(i).lower, kWidestFlexion), 2);
    }
    if (turn > most) most = turn, flexion.positions = parallel;
  }
  return flexion;
}

Vector3d flexion_origin(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion) {
  return pose_finger(tree, finger, mid_pose(tree)).origin[flexion.positions.front()];
}

double flexion_rate(const KinematicTree& tree, const FingerSkeleton& finger, const FingerPose& pose, int position,
                    int last) {
  const Joint& joint = tree.joints[finger.joints[position]];
  const double sense = dot(pose.axis[position], pose.axis[last]) < 0 ? -1.0 : 1.0;
  return sense * (joint.mimic_master >= 0 ? joint.mimic_multiplier : 1.0);
}

std::vector<int> straighten(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion,
                            std::span<double> q) {
  const auto variable_at = [&](std::size_t i) { return independent_joint(tree, finger.joints[flexion.positions[i]]); };
  const double tolerance = kStraightTolerance * finger_length(tree, finger);
  std::vector<int> set;
  for (std::size_t i = flexion.positions.size(); i-- > 1;) {
    const int variable = variable_at(i);
    if (std::ranges::find(set, variable) != set.end()) continue;

    // the joint before those that the variable drives: the tip's distance from it tells how straight they are
    std::size_t first_driven = 0;
    while (variable_at(first_driven) != variable) ++first_driven;
    const int base = flexion.positions[first_driven == 0 ? 0 : first_driven - 1];
    const auto reach = [&](double value) {
      set_with_followers(tree, variable, value, q);
      const FingerPose pose = pose_finger(tree, finger, q);
      return norm(pose.tip - pose.origin[base]);
    };

    // zero or mid range where that costs little reach, unless it is far from straight nevertheless
    const Joint& joint = tree.joints[variable];
    const double preferred = preferred_value(joint, tolerance, true, reach);
    const double straight = preferred_value(joint, 0, true, reach);
    set_with_followers(tree, variable, std::abs(preferred - straight) <= kStraightAngle ? preferred : straight, q);
    set.push_back(variable);
  }
  return set;
}

bool has_zero(const Joint& joint) { return joint.lower <= kZeroSlack && joint.upper >= -kZeroSlack; }

std::optional<bool> is_straight_at_zero(const KinematicTree& tree, const FingerSkeleton& finger,
                                        const FlexionJoints& flexion, std::vector<double> q) {
  const std::vector<int> straight = straighten(tree, finger, flexion, q);
  if (straight.empty()) return std::nullopt;
  return std::ranges::all_of(straight, [&](int variable) { return q[variable] == 0; });
}

}  // namespace uhas
