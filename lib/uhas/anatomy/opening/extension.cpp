#include "uhas/anatomy/opening/extension.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "uhas/anatomy/opening/preferred_value.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

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
/// The same axis is in the plane of flexion, but for 20 degrees (sine).
constexpr double kOutOfFlexionPlane = 0.35;
/// Standard error of a base angle that the designer's zero, a metacarpal or a side joint's axis tells (rad).
constexpr double kKnownBaseError = 0.09;
/// The same where only the joint's range tells it, as a part of that range: a wide one may bend far back.
constexpr double kGuessedBaseError = 0.16;

/// The first flexion joint of one finger, free to turn, with the joints beyond it straight in `q`.
class FingerBase {
 public:
  FingerBase(const KinematicTree& tree, const FingerSkeleton& finger, const Flexion& flexion, std::span<double> q)
      : tree_(tree),
        finger_(finger),
        flexion_(flexion),
        first_(flexion.positions.front()),
        variable_(independent_joint(tree, finger.joints[first_])),
        joint_(tree.joints[variable_]),
        sense_(flexion.closing.sign *
               flexion_rate(tree, finger, pose_finger(tree, finger, q), first_, flexion.positions.back())),
        q_(q) {}

  void set(double value) { set_with_followers(tree_, variable_, clamp_to_limits(joint_, value), q_); }

  /// Turns it so that the finger closes by `angle` (rad).
  void close_by(double angle) { set(q_[variable_] + angle / sense_); }

  void set_to_open_end() { set(open_end()); }

  /// Just short of the open end.
  void set_by_range() {
    const double bent_back = std::max(std::min(kTypicalHyperextension, range() / 4), range() - kTypicalClosing);
    set(open_end() + (sense_ > 0 ? bent_back : -bent_back));
  }

  /// Straight with what lies between the finger's root and this joint: the tip is farthest from the root.
  void continue_metacarpal(bool zero_is_neutral) {
    const double tolerance = kStraightTolerance * finger_length(tree_, finger_);
    set(preferred_value(joint_, tolerance, zero_is_neutral, [&](double value) {
      set_with_followers(tree_, variable_, value, q_);
      const FingerPose pose = pose_finger(tree_, finger_, q_);
      return norm(pose.tip - pose.origin.front());
    }));
  }

  /// How far the finger would have to close (rad) for `axis`, which belongs to the palm, to stand along the closing
  /// direction or along the finger's own; nothing when it does neither nearly.
  std::optional<double> turn_to(Vector3d axis) const {
    const FingerPosture posture = measure_posture(tree_, finger_, flexion_, q_);
    if (std::abs(dot(axis, posture.axis)) > kOutOfFlexionPlane) return std::nullopt;
    const double angle = std::atan2(dot(axis, posture.closing), dot(axis, posture.direction));
    const double turn = std::remainder(angle, std::numbers::pi / 2);
    if (std::abs(turn) > kPalmAxisDeviation) return std::nullopt;
    return turn;
  }

  /// The same for the axis of a side joint right before it, which turns about the palm normal or about the finger.
  std::optional<double> turn_to_side_joint() const {
    if (first_ == 0 || tree_.joints[finger_.joints[first_ - 1]].kind == JointKind::prismatic) return std::nullopt;
    return turn_to(pose_finger(tree_, finger_, q_).axis[first_ - 1]);
  }

  bool has_metacarpal() const {
    const FingerPose pose = pose_finger(tree_, finger_, q_);
    return norm(pose.origin[first_] - pose.origin.front()) > kShortestMetacarpal * finger_length(tree_, finger_);
  }

  const Joint& joint() const { return joint_; }
  int variable() const { return variable_; }
  double range() const { return joint_.upper - joint_.lower; }

 private:
  double open_end() const { return sense_ > 0 ? joint_.lower : joint_.upper; }

  const KinematicTree& tree_;
  const FingerSkeleton& finger_;
  const Flexion& flexion_;
  int first_;  ///< its position in the finger
  int variable_;
  const Joint& joint_;
  double sense_;  ///< rate of closing per unit of the variable
  std::span<double> q_;
};

}  // namespace

BaseAngle extend_finger(const KinematicTree& tree, const FingerSkeleton& finger, const Flexion& flexion,
                        const BaseEvidence& evidence, std::span<double> q) {
  constexpr BaseAngle known{kKnownBaseError, false};

  // the phalanges straight; then the first joint, unless it follows with them
  const std::vector<int> straight = straighten(tree, finger, flexion, q);
  FingerBase base(tree, finger, flexion, q);
  if (std::ranges::find(straight, base.variable()) != straight.end()) return known;
  if (flexion.sliding) {
    base.set_to_open_end();
    return known;
  }

  // its angle to the palm, by the witness that knows it best
  BaseAngle angle = known;
  if (evidence.zero_is_straight && has_zero(base.joint())) {
    base.set(0);
  } else if (base.has_metacarpal()) {
    base.continue_metacarpal(evidence.zero_is_straight);
  } else {
    base.set_by_range();
    angle = {kGuessedBaseError * base.range(), true};
    const auto turn = evidence.slab ? base.turn_to(evidence.slab->normal) : std::nullopt;
    if (turn) {
      base.close_by(*turn);
      angle = {std::min(angle.error, evidence.slab->error), false};
    }
  }

  // a side joint before it is a second witness: two estimates are better than one, and their difference tells how good
  // they are; a guess gives way
  const std::optional<double> turn = base.turn_to_side_joint();
  if (!turn) return angle;
  base.close_by(angle.is_guess ? *turn : *turn / 2);
  return angle.is_guess ? known : BaseAngle{std::max(kKnownBaseError, std::abs(*turn) / 2), false};
}

ExtendedHand extend_hand(const HandSkeleton& hand, const HandMotion& motion, std::vector<double> q) {
  const BaseEvidence evidence = {motion.zero_is_straight, motion.slab};
  ExtendedHand extended;

  // each finger by itself, from the same pose
  std::vector<double> sum(q.size(), 0.0), wanted(q.size(), 0.0);
  for (std::size_t i = 0; i < hand.fingers.size(); ++i) {
    const FingerSkeleton& finger = hand.fingers[i];
    const Flexion& flexion = motion.flexions[i];
    std::vector<double> alone = q;
    const BaseAngle found = extend_finger(hand.tree, finger, flexion, evidence, alone);
    const bool is_stated = motion.held[independent_joint(hand.tree, finger.joints[flexion.positions.front()])];
    extended.bases.push_back(is_stated ? BaseAngle{} : found);
    for (int joint : finger.joints) {
      const int variable = independent_joint(hand.tree, joint);
      sum[variable] += alone[variable];
      ++wanted[variable];
    }
  }

  // a joint of several fingers in the middle of what they want
  for (std::size_t i = 0; i < q.size(); ++i)
    if (wanted[i] > 0 && !motion.held[i]) q[i] = sum[i] / wanted[i];
  apply_mimics(hand.tree, q);
  extended.postures = measure_postures(hand, motion.flexions, q);
  extended.q = std::move(q);
  return extended;
}

}  // namespace uhas
