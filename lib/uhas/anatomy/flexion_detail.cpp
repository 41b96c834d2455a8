#include "uhas/anatomy/flexion_detail.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "uhas/anatomy/palm_slab_detail.hpp"
#include "uhas/runtime/forward_kinematics.hpp"

namespace uhas {
namespace {

/// A joint turns the tip when the tip is this part of the finger's length off its axis.
constexpr double kShortestArm = 0.1;
/// Flexion axes are parallel within 30 degrees: side joints between them stand at mid range, which need not be neutral.
constexpr double kParallel = 0.866;
/// A straight phalanx at zero may be this part shorter than the longest reach: fingertips are offset from the joint's
/// line.
constexpr double kStraightTolerance = 0.015;
/// ... but no further from straight than this (rad): short phalanges bend far before they cost reach.
constexpr double kStraightAngle = 0.15;
/// Fingers bend back at most this far (rad); a zero so near to the open end is where the designer put "straight".
constexpr double kHyperextension = 0.4;
/// Where "straight" lies from the open end on when zero does not tell (rad).
constexpr double kTypicalHyperextension = 0.15;

/// Ranges that differ by this part of their sum tell the closing side.
constexpr double kClearAsymmetry = 0.3;
/// A side joint's axis, or the palm's slab, tells how the palm lies when it is within 25 degrees of a right angle to where
/// the finger seems to be.
constexpr double kPalmAxisDeviation = 0.44;
/// Standard errors of the angle between a finger's base and the palm (rad): where the designer's zero, a metacarpal or a
/// side joint's axis tells it; where only the range of the joint is known.
constexpr double kKnownBaseError = 0.09, kGuessedBaseError = 0.26;
/// A zero this far outside the limits still counts as their end (rad).
constexpr double kZeroSlack = 0.02;
/// From this part of the finger's length on, what lies between its root and its first flexion joint is a phalanx too,
/// and the finger is straight when it continues that.
constexpr double kShortestMetacarpal = 0.15;

/// Signed rate of flexion joint `position` per unit of its variable, seen along the last flexion axis.
double flexion_rate(const Anatomy& anatomy, const FingerAnatomy& finger, const FingerPose& pose, int position,
                    int last) {
  const Joint& joint = anatomy.tree.joints[finger.joints[position]];
  const double sense = dot(pose.axis[position], pose.axis[last]) < 0 ? -1.0 : 1.0;
  return sense * (joint.mimic_master >= 0 ? joint.mimic_multiplier : 1.0);
}

/// Straightens the flexion joints beyond the first: from the last inward, each variable puts the tip farthest from the
/// joint before those that it drives. Returns the variables that were set.
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
    const double preferred = preferred_value(joint, tolerance, reach), straight = preferred_value(joint, 0, reach);
    set_joint(anatomy.tree, variable, std::abs(preferred - straight) <= kStraightAngle ? preferred : straight, q);
    set.push_back(variable);
  }
  return set;
}

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

/// How far the finger would have to close (rad) for `axis`, which belongs to the palm, to stand along the closing
/// direction or along the finger's own; nothing when it does neither nearly.
std::optional<double> turn_to_axis(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                                   std::span<const double> q, Vector3d axis, FingerPose& pose) {
  constexpr double quarter = std::numbers::pi / 2, across = 0.35;
  const FingerPosture posture = measure_posture(anatomy, finger, flexion, q, pose);
  if (std::abs(dot(axis, posture.axis)) > across) return std::nullopt;
  const double angle = std::atan2(dot(axis, posture.closing), dot(axis, posture.direction));
  const double turn = std::remainder(angle, quarter);
  if (std::abs(turn) > kPalmAxisDeviation) return std::nullopt;
  return turn;
}

}  // namespace

Flexion find_flexion(const Anatomy& anatomy, const FingerAnatomy& finger) {
  const auto is_prismatic = [&](int position) {
    return anatomy.tree.joints[finger.joints[position]].kind == JointKind::prismatic;
  };
  FingerPose pose;
  pose_finger(anatomy, finger, mid_pose(anatomy.tree), pose);
  const double length = finger_length(anatomy, finger);
  const auto moves_tip = [&](int position) {
    const Vector3d arm = cross(pose.axis[position], pose.tip - pose.origin[position]);
    return is_prismatic(position) || norm(arm) >= kShortestArm * length;
  };

  Flexion flexion;
  int last = static_cast<int>(finger.joints.size()) - 1;
  while (last > 0 && !moves_tip(last)) --last;
  if (is_prismatic(last)) {
    flexion.sliding = true;
    flexion.positions = {last};
    return flexion;
  }
  for (int i = 0; i <= last; ++i)
    if (!is_prismatic(i) && std::abs(dot(pose.axis[i], pose.axis[last])) > kParallel) flexion.positions.push_back(i);
  return flexion;
}

Vector3d flexion_origin(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion) {
  FingerPose pose;
  pose_finger(anatomy, finger, mid_pose(anatomy.tree), pose);
  return pose.origin[flexion.positions.front()];
}

void find_closing_side(const Anatomy& anatomy, const FingerAnatomy& finger, Vector3d hand_center, Flexion& flexion) {
  const std::vector<Joint>& joints = anatomy.tree.joints;
  std::vector<double> q = mid_pose(anatomy.tree);
  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  if (flexion.sliding) return find_jaw_closing_side(pose, hand_center, flexion);

  const int first = flexion.positions.front(), last = flexion.positions.back();
  std::vector<int> extended = straighten(anatomy, finger, flexion, q);
  weigh_ranges(anatomy, finger, q, extended, flexion);
  const int variable = variable_of(anatomy.tree, finger.joints[first]);
  const bool is_free = std::find(extended.begin(), extended.end(), variable) == extended.end();
  if (flexion.evidence >= kClearAsymmetry || !is_free) return;

  // The distal joints do not tell: ask the first one too, which is extended where it points away from the hand.
  pose_finger(anatomy, finger, q, pose);
  const Vector3d outward = orthogonal_part(pose.origin[first] - hand_center, pose.axis[last]);
  if (norm(outward) <= kShortestArm * finger_length(anatomy, finger)) return;
  const double outermost = preferred_value(joints[variable], 0, [&](double value) {
    set_joint(anatomy.tree, variable, value, q);
    pose_finger(anatomy, finger, q, pose);
    return dot(pose.tip - pose.origin[first], outward);
  });
  set_joint(anatomy.tree, variable, outermost, q);
  extended.push_back(variable);
  weigh_ranges(anatomy, finger, q, extended, flexion);
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

double extend_finger(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                     const BaseEvidence& evidence, std::span<double> q) {
  const std::vector<int> straight = straighten(anatomy, finger, flexion, q);
  const int first = flexion.positions.front();
  const int variable = variable_of(anatomy.tree, finger.joints[first]);
  if (std::find(straight.begin(), straight.end(), variable) != straight.end()) return kKnownBaseError;

  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  const Joint& joint = anatomy.tree.joints[variable];
  const double sense = flexion.closing_sign * flexion_rate(anatomy, finger, pose, first, flexion.positions.back());
  const double open_end = sense > 0 ? joint.lower : joint.upper;
  const double length = finger_length(anatomy, finger);
  const bool zero_in_range = joint.lower <= kZeroSlack && joint.upper >= -kZeroSlack;
  double value = open_end, error = kKnownBaseError;
  if (flexion.sliding) {
    // a jaw is open at the end of its range
  } else if (evidence.zero_is_straight && zero_in_range && std::abs(open_end) <= kHyperextension) {
    value = clamp_to_limits(joint, 0.0);
  } else if (norm(pose.origin[first] - pose.origin.front()) > kShortestMetacarpal * length) {
    value = preferred_value(joint, kStraightTolerance * length, [&](double candidate) {
      set_joint(anatomy.tree, variable, candidate, q);
      pose_finger(anatomy, finger, q, pose);
      return norm(pose.tip - pose.origin.front());
    });
  } else {
    const double bent_back = std::min(kTypicalHyperextension, (joint.upper - joint.lower) / 4);
    value = open_end + (sense > 0 ? bent_back : -bent_back);
    error = kGuessedBaseError;
  }
  set_joint(anatomy.tree, variable, value, q);
  const auto turn_by = [&](double angle) {
    value = clamp_to_limits(joint, value + angle / sense);
    set_joint(anatomy.tree, variable, value, q);
  };
  if (flexion.sliding) return error;

  if (error == kGuessedBaseError && evidence.slab) {
    const std::optional<double> turn = turn_to_axis(anatomy, finger, flexion, q, *evidence.slab, pose);
    if (turn) turn_by(*turn), error = kSlabError;
  }
  if (first == 0) return error;

  // A side joint before it turns about the palm normal or about the finger: two estimates are better than one.
  pose_finger(anatomy, finger, q, pose);
  if (anatomy.tree.joints[finger.joints[first - 1]].kind == JointKind::prismatic) return error;
  const std::optional<double> turn = turn_to_axis(anatomy, finger, flexion, q, pose.axis[first - 1], pose);
  if (!turn) return error;
  turn_by(error == kGuessedBaseError ? *turn : *turn / 2);
  return kKnownBaseError;
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
