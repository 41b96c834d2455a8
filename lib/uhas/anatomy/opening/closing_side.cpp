#include "uhas/anatomy/opening/closing_side.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/anatomy/opening/preferred_value.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// Ranges that differ by this part of their sum tell the closing side.
constexpr double kClearAsymmetry = 0.3;
/// What they tell at most when "extended" is only where the finger points away from the hand.
constexpr double kOutwardEvidence = 0.3;
/// A finger's base stands beside the hand's middle from this part of the finger's length on.
constexpr double kShortestWayOut = 0.1;
/// Flexion axes of neighbours are parallel within 30 degrees.
constexpr double kParallel = 0.866;
/// Neighbours' knuckles lie along their axes to within 45 degrees.
constexpr double kSideBySide = 0.7;

/// Closing side and evidence from the ranges to both sides of the `extended` variables' values in `q`.
ClosingSide weigh_ranges(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion,
                         std::span<const double> q, const std::vector<int>& extended) {
  const FingerPose pose = pose_finger(tree, finger, q);
  double positive = 0, negative = 0;
  for (int position : flexion.positions) {
    const int variable = independent_joint(tree, finger.joints[position]);
    if (std::ranges::find(extended, variable) == extended.end()) continue;
    const Joint& joint = tree.joints[variable];
    const double rate = flexion_rate(tree, finger, pose, position, flexion.positions.back());
    const double up = joint.upper - q[variable], down = q[variable] - joint.lower;
    positive += std::abs(rate) * (rate > 0 ? up : down);
    negative += std::abs(rate) * (rate > 0 ? down : up);
  }
  return {positive < negative ? -1.0 : 1.0,
          positive + negative > 0 ? std::abs(positive - negative) / (positive + negative) : 0};
}

/// A jaw closes toward the middle of the hand.
ClosingSide closing_side_of_jaw(const FingerPose& pose, const FlexionJoints& flexion, Vector3d hand_center) {
  const Vector3d inward = hand_center - pose.tip;
  const double toward = dot(inward, pose.axis[flexion.positions.back()]);
  return {toward < 0 ? -1.0 : 1.0, norm(inward) > 0 ? std::min(1.0, 2 * std::abs(toward) / norm(inward)) : 0};
}

}  // namespace

ClosingSide find_closing_side(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion,
                              Vector3d hand_center, bool zero_is_straight) {
  std::vector<double> q = mid_pose(tree);
  if (flexion.sliding) return closing_side_of_jaw(pose_finger(tree, finger, q), flexion, hand_center);

  // the joints between phalanges are extended where the finger is straight; the first one at a zero that its
  // designer called open
  const int first = flexion.positions.front(), last = flexion.positions.back();
  std::vector<int> extended = straighten(tree, finger, flexion, q);
  const int variable = independent_joint(tree, finger.joints[first]);
  const Joint& base = tree.joints[variable];
  const bool is_free = std::ranges::find(extended, variable) == extended.end();
  const bool open_at_zero = zero_is_straight && has_zero(base);
  if (is_free && open_at_zero) {
    set_with_followers(tree, variable, clamp_to_limits(base, 0.0), q);
    extended.push_back(variable);
  }
  const ClosingSide side = weigh_ranges(tree, finger, flexion, q, extended);
  if (side.evidence >= kClearAsymmetry || !is_free || open_at_zero) return side;

  // they do not tell: ask the first one too, which is extended where it points away from the hand
  const FingerPose pose = pose_finger(tree, finger, q);
  const Vector3d outward = orthogonal_part(pose.origin[first] - hand_center, pose.axis[last]);
  if (norm(outward) <= kShortestWayOut * finger_length(tree, finger)) return side;
  const double outermost = preferred_value(base, 0, true, [&](double value) {
    set_with_followers(tree, variable, value, q);
    const FingerPose turned = pose_finger(tree, finger, q);
    return dot(turned.tip - turned.origin[first], outward);
  });
  set_with_followers(tree, variable, outermost, q);
  extended.push_back(variable);
  const ClosingSide with_base = weigh_ranges(tree, finger, flexion, q, extended);
  return {with_base.sign, std::min(with_base.evidence, kOutwardEvidence)};
}

std::vector<ClosingSide> agree_on_closing_side(const HandSkeleton& hand, std::span<const Flexion> flexions) {
  // where each finger is hinged, everything at mid range
  struct Hinge {
    Vector3d origin, axis;  // the axis turned such that a positive turn closes
  };
  std::vector<Hinge> hinges;
  const std::vector<double> q = mid_pose(hand.tree);
  for (std::size_t i = 0; i < flexions.size(); ++i) {
    const FingerPose pose = pose_finger(hand.tree, hand.fingers[i], q);
    hinges.push_back({pose.origin[flexions[i].positions.front()],
                      flexions[i].closing.sign * pose.axis[flexions[i].positions.back()]});
  }
  const auto are_neighbours = [&](std::size_t i, std::size_t j) {
    const Vector3d apart = normalized(hinges[j].origin - hinges[i].origin);
    return j != i && !flexions[j].sliding && std::abs(dot(hinges[i].axis, hinges[j].axis)) >= kParallel &&
           std::abs(dot(apart, hinges[i].axis)) >= kSideBySide;
  };

  // each finger and its neighbours vote; the mean of the votes is its evidence from now on
  std::vector<ClosingSide> agreed;
  for (std::size_t i = 0; i < flexions.size(); ++i) {
    ClosingSide side = flexions[i].closing;
    if (!flexions[i].sliding) {
      double votes = side.evidence, voters = 1;
      for (std::size_t j = 0; j < flexions.size(); ++j) {
        if (!are_neighbours(i, j)) continue;
        const double evidence = flexions[j].closing.evidence;
        votes += dot(hinges[i].axis, hinges[j].axis) > 0 ? evidence : -evidence;
        ++voters;
      }
      if (votes < 0) side.sign = -side.sign;
      side.evidence = std::abs(votes) / voters;
    }
    agreed.push_back(side);
  }
  return agreed;
}

}  // namespace uhas
