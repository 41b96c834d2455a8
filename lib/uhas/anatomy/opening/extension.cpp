#include "uhas/anatomy/opening/extension.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// Where "straight" lies from the open end on when nothing else tells (rad): this far, or so far that the joint closes
/// by no more than a finger's base does.
constexpr double kTypicalHyperextension = 0.15, kTypicalClosing = 1.65;
/// From this part of the finger's length on, what lies between its root and its first flexion joint is a phalanx too,
/// and the finger is straight when it continues that.
constexpr double kShortestMetacarpal = 0.15;
/// A side joint's axis, or the palm's slab, tells how the palm lies when it is within 25 degrees of a right angle to
/// where the finger seems to be.
constexpr double kPalmAxisDeviation = 0.44;
/// Standard error of a base angle that the designer's zero, a metacarpal or a side joint's axis tells (rad).
constexpr double kKnownBaseError = 0.09;
/// The same where only the joint's range tells it, as a part of that range: a wide one may bend far back.
constexpr double kGuessedBaseError = 0.16;

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

void extend_finger(const Anatomy& anatomy, const FingerAnatomy& finger, const BaseEvidence& evidence, Flexion& flexion,
                   std::span<double> q) {
  flexion.base_error = kKnownBaseError;
  flexion.base_is_guess = false;
  const std::vector<int> straight = straighten(anatomy, finger, flexion, q);
  const int first = flexion.positions.front();
  const int variable = variable_of(anatomy.tree, finger.joints[first]);
  if (std::ranges::find(straight, variable) != straight.end()) return;

  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  const Joint& joint = anatomy.tree.joints[variable];
  const double sense = flexion.closing_sign * flexion_rate(anatomy, finger, pose, first, flexion.positions.back());
  const double open_end = sense > 0 ? joint.lower : joint.upper;
  if (flexion.sliding) return set_joint(anatomy.tree, variable, open_end, q);

  const double length = finger_length(anatomy, finger), range = joint.upper - joint.lower;
  double value = 0;
  const auto set_base = [&](double wanted) {
    value = clamp_to_limits(joint, wanted);
    set_joint(anatomy.tree, variable, value, q);
  };
  if (evidence.zero_is_straight && has_zero(joint)) {
    set_base(0);
  } else if (norm(pose.origin[first] - pose.origin.front()) > kShortestMetacarpal * length) {
    set_base(preferred_value(joint, kStraightTolerance * length, evidence.zero_is_straight, [&](double candidate) {
      set_joint(anatomy.tree, variable, candidate, q);
      pose_finger(anatomy, finger, q, pose);
      return norm(pose.tip - pose.origin.front());
    }));
  } else {
    const double bent_back = std::max(std::min(kTypicalHyperextension, range / 4), range - kTypicalClosing);
    set_base(open_end + (sense > 0 ? bent_back : -bent_back));
    flexion.base_error = kGuessedBaseError * range;
    flexion.base_is_guess = true;
    if (evidence.slab) {
      if (const auto turn = turn_to_axis(anatomy, finger, flexion, q, evidence.slab->normal, pose)) {
        set_base(value + *turn / sense);
        flexion.base_error = std::min(flexion.base_error, evidence.slab->error);
        flexion.base_is_guess = false;
      }
    }
  }
  if (first == 0 || anatomy.tree.joints[finger.joints[first - 1]].kind == JointKind::prismatic) return;

  // A side joint before it turns about the palm normal or about the finger. Two estimates are better than one, and
  // their difference tells how good they are.
  pose_finger(anatomy, finger, q, pose);
  const std::optional<double> turn = turn_to_axis(anatomy, finger, flexion, q, pose.axis[first - 1], pose);
  if (!turn) return;
  set_base(value + (flexion.base_is_guess ? *turn : *turn / 2) / sense);
  flexion.base_error = flexion.base_is_guess ? kKnownBaseError : std::max(kKnownBaseError, std::abs(*turn) / 2);
  flexion.base_is_guess = false;
}

}  // namespace uhas
