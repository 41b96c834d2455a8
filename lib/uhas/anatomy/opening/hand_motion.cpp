#include "uhas/anatomy/opening/hand_motion.hpp"

#include <optional>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// Whether most of the fingers whose phalanges can tell are straight at zero.
bool are_straight_at_zero(const HandSkeleton& hand, const std::vector<FlexionJoints>& flexions,
                          const std::vector<double>& q) {
  int votes = 0;
  for (std::size_t i = 0; i < flexions.size(); ++i)
    if (const auto straight = is_straight_at_zero(hand.tree, hand.fingers[i], flexions[i], q))
      votes += *straight ? 1 : -1;
  return votes > 0;
}

}  // namespace

StartPose make_start_pose(const KinematicTree& tree, const HandConfig& config) {
  const std::vector<std::optional<double>> stated = resolve_joint_values(tree, config.q_open, config, "q_open");
  StartPose start;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    start.q.push_back(stated[i].value_or(mid_range(tree.joints[i])));
    start.held.push_back(stated[i].has_value());
  }
  apply_mimics(tree, start.q);
  return start;
}

HandMotion find_hand_motion(const HandModel& model, const PalmTree& palm, const HandSkeleton& hand,
                            const StartPose& start) {
  // which joints bend each finger, and where these begin
  std::vector<FlexionJoints> joints;
  Vector3d knuckle_center;
  for (const FingerSkeleton& finger : hand.fingers) {
    joints.push_back(find_flexion_joints(hand.tree, finger));
    knuckle_center += flexion_origin(hand.tree, finger, joints.back()) / static_cast<double>(hand.fingers.size());
  }

  // to which side each of them closes, and what neighbours make of that
  HandMotion motion;
  motion.zero_is_straight = are_straight_at_zero(hand, joints, start.q);
  for (std::size_t i = 0; i < joints.size(); ++i)
    motion.flexions.push_back(
        {joints[i], find_closing_side(hand.tree, hand.fingers[i], joints[i], knuckle_center, motion.zero_is_straight)});
  const std::vector<ClosingSide> agreed = agree_on_closing_side(hand, motion.flexions);
  for (std::size_t i = 0; i < agreed.size(); ++i) motion.flexions[i].closing = agreed[i];

  motion.slab = find_palm_slab(model, palm, knuckle_center);
  motion.held = start.held;
  return motion;
}

}  // namespace uhas
