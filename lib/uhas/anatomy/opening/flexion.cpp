#include "uhas/anatomy/opening/flexion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "uhas/kinematics/forward_kinematics.hpp"

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

/// Ranges that differ by this part of their sum tell the closing side.
constexpr double kClearAsymmetry = 0.3;
/// What they tell at most when "extended" is only where the finger points away from the hand.
constexpr double kOutwardEvidence = 0.3;

/// A zero this far outside the limits still counts as their end (rad).
constexpr double kZeroSlack = 0.02;

/// Closing side and evidence from the ranges to both sides of the `extended` variables' values in `q`.
void weigh_ranges(const Anatomy& anatomy, const FingerAnatomy& finger, std::span<const double> q,
                  const std::vector<int>& extended, Flexion& flexion) {
  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  double positive = 0, negative = 0;
  for (int position : flexion.positions) {
    const int variable = variable_of(anatomy.tree, finger.joints[position]);
    if (std::find(extended.begin(), extended.end(), variable) == extended.end()) continue;
    const Joint& joint = anatomy.tree.joints[variable];
    const double rate = flexion_rate(anatomy, finger, pose, position, flexion.positions.back());
    const double up = joint.upper - q[variable], down = q[variable] - joint.lower;
    positive += std::abs(rate) * (rate > 0 ? up : down);
    negative += std::abs(rate) * (rate > 0 ? down : up);
  }
  flexion.closing_sign = positive < negative ? -1 : 1;
  flexion.evidence = positive + negative > 0 ? std::abs(positive - negative) / (positive + negative) : 0;
}

/// A jaw closes toward the middle of the hand.
void find_jaw_closing_side(const FingerPose& pose, Vector3d hand_center, Flexion& flexion) {
  const Vector3d inward = hand_center - pose.tip;
  const double toward = dot(inward, pose.axis[flexion.positions.back()]);
  flexion.closing_sign = toward < 0 ? -1 : 1;
  flexion.evidence = norm(inward) > 0 ? std::min(1.0, 2 * std::abs(toward) / norm(inward)) : 0;
}

}  // namespace

Flexion find_flexion(const Anatomy& anatomy, const FingerAnatomy& finger) {
  const auto is_prismatic = [&](int position) {
    return anatomy.tree.joints[finger.joints[position]].kind == JointKind::prismatic;
  };
  FingerPose pose;
  pose_finger(anatomy, finger, mid_pose(anatomy.tree), pose);
  const int count = static_cast<int>(finger.joints.size());
  Flexion flexion;
  flexion.sliding = is_prismatic(count - 1);
  if (flexion.sliding) {
    flexion.positions = {count - 1};
    return flexion;
  }
  const double length = finger_length(anatomy, finger);
  const auto bends = [&](int position) {
    const Vector3d arm = cross(pose.axis[position], pose.tip - pose.origin[position]);
    return !is_prismatic(position) && norm(arm) >= kShortestArm * length;
  };
  double most = -1;
  for (int reference = count - 1; reference >= 0; --reference) {
    std::vector<int> parallel;
    double turn = 0;  // squares, for one wide joint bends a finger rather than two narrow ones
    for (int i = 0; i < count; ++i) {
      if (is_prismatic(i) || std::abs(dot(pose.axis[i], pose.axis[reference])) <= kParallel) continue;
      const Joint& joint = anatomy.tree.joints[finger.joints[i]];
      parallel.push_back(i);
      if (bends(i)) turn += std::pow(std::min(joint.upper - joint.lower, kWidestFlexion), 2);
    }
    if (turn > most) most = turn, flexion.positions = parallel;
  }
  return flexion;
}

double flexion_rate(const Anatomy& anatomy, const FingerAnatomy& finger, const FingerPose& pose, int position,
                    int last) {
  const Joint& joint = anatomy.tree.joints[finger.joints[position]];
  const double sense = dot(pose.axis[position], pose.axis[last]) < 0 ? -1.0 : 1.0;
  return sense * (joint.mimic_master >= 0 ? joint.mimic_multiplier : 1.0);
}

std::vector<int> straighten(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                            std::span<double> q) {
  const auto variable_at = [&](std::size_t i) {
    return variable_of(anatomy.tree, finger.joints[flexion.positions[i]]);
  };
  const double tolerance = kStraightTolerance * finger_length(anatomy, finger);
  std::vector<int> set;
  FingerPose pose;
  for (std::size_t i = flexion.positions.size(); i-- > 1;) {
    const int variable = variable_at(i);
    if (std::find(set.begin(), set.end(), variable) != set.end()) continue;
    std::size_t first_driven = 0;
    while (variable_at(first_driven) != variable) ++first_driven;
    const int base = flexion.positions[first_driven == 0 ? 0 : first_driven - 1];
    const auto reach = [&](double value) {
      set_joint(anatomy.tree, variable, value, q);
      pose_finger(anatomy, finger, q, pose);
      return norm(pose.tip - pose.origin[base]);
    };
    const Joint& joint = anatomy.tree.joints[variable];
    const double preferred = preferred_value(joint, tolerance, true, reach);
    const double straight = preferred_value(joint, 0, true, reach);
    set_joint(anatomy.tree, variable, std::abs(preferred - straight) <= kStraightAngle ? preferred : straight, q);
    set.push_back(variable);
  }
  return set;
}

bool has_zero(const Joint& joint) { return joint.lower <= kZeroSlack && joint.upper >= -kZeroSlack; }

Vector3d flexion_origin(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion) {
  FingerPose pose;
  pose_finger(anatomy, finger, mid_pose(anatomy.tree), pose);
  return pose.origin[flexion.positions.front()];
}

void find_closing_side(const Anatomy& anatomy, const FingerAnatomy& finger, Vector3d hand_center, bool zero_is_straight,
                       Flexion& flexion) {
  const std::vector<Joint>& joints = anatomy.tree.joints;
  std::vector<double> q = mid_pose(anatomy.tree);
  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  if (flexion.sliding) return find_jaw_closing_side(pose, hand_center, flexion);

  const int first = flexion.positions.front(), last = flexion.positions.back();
  std::vector<int> extended = straighten(anatomy, finger, flexion, q);
  const int variable = variable_of(anatomy.tree, finger.joints[first]);
  const bool is_free = std::find(extended.begin(), extended.end(), variable) == extended.end();
  const bool open_at_zero = zero_is_straight && has_zero(joints[variable]);
  if (is_free && open_at_zero) {
    set_joint(anatomy.tree, variable, clamp_to_limits(joints[variable], 0.0), q);
    extended.push_back(variable);
  }
  weigh_ranges(anatomy, finger, q, extended, flexion);
  if (flexion.evidence >= kClearAsymmetry || !is_free || open_at_zero) return;

  // The distal joints do not tell: ask the first one too, which is extended where it points away from the hand.
  pose_finger(anatomy, finger, q, pose);
  const Vector3d outward = orthogonal_part(pose.origin[first] - hand_center, pose.axis[last]);
  if (norm(outward) <= kShortestArm * finger_length(anatomy, finger)) return;
  const double outermost = preferred_value(joints[variable], 0, true, [&](double value) {
    set_joint(anatomy.tree, variable, value, q);
    pose_finger(anatomy, finger, q, pose);
    return dot(pose.tip - pose.origin[first], outward);
  });
  set_joint(anatomy.tree, variable, outermost, q);
  extended.push_back(variable);
  weigh_ranges(anatomy, finger, q, extended, flexion);
  flexion.evidence = std::min(flexion.evidence, kOutwardEvidence);
}

void agree_on_closing_side(const Anatomy& anatomy, std::span<Flexion> flexions) {
  constexpr double side_by_side = 0.7;
  struct Hinge {
    Vector3d origin, axis;  // the axis turned such that a positive turn closes
  };
  std::vector<Hinge> hinges;
  const std::vector<double> q = mid_pose(anatomy.tree);
  FingerPose pose;
  for (std::size_t i = 0; i < flexions.size(); ++i) {
    pose_finger(anatomy, anatomy.fingers[i], q, pose);
    const Vector3d axis = flexions[i].closing_sign * pose.axis[flexions[i].positions.back()];
    hinges.push_back({pose.origin[flexions[i].positions.front()], axis});
  }
  const std::vector<Flexion> before(flexions.begin(), flexions.end());
  for (std::size_t i = 0; i < flexions.size(); ++i) {
    if (flexions[i].sliding) continue;
    double votes = before[i].evidence, voters = 1;
    for (std::size_t j = 0; j < flexions.size(); ++j) {
      const Vector3d apart = normalized(hinges[j].origin - hinges[i].origin);
      const double alike = dot(hinges[i].axis, hinges[j].axis);
      if (j == i || before[j].sliding || std::abs(alike) < kParallel ||
          std::abs(dot(apart, hinges[i].axis)) < side_by_side)
        continue;
      votes += alike > 0 ? before[j].evidence : -before[j].evidence;
      ++voters;
    }
    if (votes < 0) flexions[i].closing_sign = -before[i].closing_sign;
    flexions[i].evidence = std::abs(votes) / voters;
  }
}

std::optional<bool> is_straight_at_zero(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                                        std::vector<double> q) {
  const std::vector<int> straight = straighten(anatomy, finger, flexion, q);
  if (straight.empty()) return std::nullopt;
  return std::all_of(straight.begin(), straight.end(), [&](int variable) { return q[variable] == 0; });
}

FingerPosture measure_posture(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                              std::span<const double> q, FingerPose& scratch) {
  pose_finger(anatomy, finger, q, scratch);
  FingerPosture posture;
  posture.root = scratch.origin.front();
  posture.tip = scratch.tip;
  posture.knuckle = scratch.origin[flexion.positions.front()];
  const Vector3d along = posture.tip - posture.knuckle;
  const Vector3d axis = flexion.closing_sign * scratch.axis[flexion.positions.back()];
  posture.direction = normalized(orthogonal_part(along, axis));
  if (flexion.sliding) {
    posture.closing = axis;
    posture.axis = cross(posture.direction, posture.closing);
  } else {
    posture.axis = axis;
    posture.closing = cross(posture.axis, posture.direction);
  }
  return posture;
}

}  // namespace uhas
