#include "uhas/anatomy/anatomy.hpp"

#include <numbers>
#include <span>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/digits/digits.hpp"
#include "uhas/anatomy/digits/thumb.hpp"
#include "uhas/anatomy/fingers/fingertip.hpp"
#include "uhas/anatomy/fingers/hand_skeleton.hpp"
#include "uhas/anatomy/opening/extension.hpp"
#include "uhas/anatomy/opening/hand_motion.hpp"
#include "uhas/anatomy/opening/open_hand.hpp"
#include "uhas/anatomy/palm/finger_chains.hpp"
#include "uhas/anatomy/palm/palm_tree.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// Outward, unit, in the tip link's frame: what the config states, else the way in which the open finger closes.
Vector3d pad_normal(const PalmTree& palm, const HandSkeleton& hand, const OpenHand& open, int finger,
                    const Fingertip& tip) {
  if (tip.pad_normal) return unit_direction(*tip.pad_normal);
  std::vector<RigidTransformd> T_palm_joint(open.q.size());
  forward_kinematics(hand.tree, open.q, T_palm_joint);
  const RigidTransformd T_palm_tip =
      T_palm_joint[hand.fingers[finger].joints.back()] * palm.links[tip.link].T_joint_link;
  return T_palm_tip.rotation.transposed() * open.postures[finger].closing;
}

/// A continuous joint turns half a turn to both sides of open, unless the config states its limits.
KinematicTree limited_about(KinematicTree tree, const std::vector<double>& q_open, const HandConfig& config) {
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    Joint& joint = tree.joints[i];
    if (joint.kind != JointKind::continuous || config.joint_limits.contains(joint.name)) continue;
    joint.lower = q_open[i] - std::numbers::pi;
    joint.upper = q_open[i] + std::numbers::pi;
  }
  return tree;
}

/// The anatomy but for the names of the digits and what is said of it.
Anatomy describe_parts(const PalmTree& palm, const HandSkeleton& hand, std::span<const Fingertip> tips,
                       const OpenHand& open, const HandConfig& config) {
  Anatomy anatomy;
  anatomy.root_link = palm.root_link;
  anatomy.palm_link = palm.palm_link;
  anatomy.T_root_palm = palm.T_root_palm;
  anatomy.tree = limited_about(palm.tree, open.q, config);
  anatomy.other_joints = palm.other_joints;
  anatomy.links = palm.links;
  anatomy.model_links = palm.model_links;
  for (int i = 0; i < hand.finger_count(); ++i)
    anatomy.fingers.push_back(
        {hand.fingers[i].joints, tips[i].link, tips[i].p_link, pad_normal(palm, hand, open, i, tips[i])});
  anatomy.palm_normal_palm = open.palm_normal_palm;
  anatomy.palm_normal_root = open.palm_normal_root;
  anatomy.q_open = open.q;
  return anatomy;
}

/// The findings in the order of the steps.
std::vector<HandFinding> collect_findings(const PalmTree& palm, std::span<const Fingertip> tips, const Thumb& thumb,
                                          const OpenHand& open, const Digits& digits) {
  std::vector<HandFinding> all = palm.findings;
  all.push_back(explain_fingertips(tips));
  all.push_back(thumb.finding);
  all.insert(all.end(), open.findings.begin(), open.findings.end());
  all.insert(all.end(), digits.findings.begin(), digits.findings.end());
  return all;
}

std::vector<std::string> collect_warnings(const PalmTree& palm, std::span<const HandFinding> findings) {
  std::vector<std::string> warnings = palm.warnings;
  for (const HandFinding& finding : findings)
    if (const std::string warning = doubt(finding); !warning.empty()) warnings.push_back(warning);
  return warnings;
}

}  // namespace

Anatomy infer_anatomy(const HandModel& model, const HandConfig& config) {
  // what the model is made of
  const FingerChains chains = find_finger_chains(model, config);
  const PalmTree palm = make_palm_tree(model, chains, config);
  const std::vector<Fingertip> tips = find_fingertips(model, palm, config);

  // how it moves
  const StartPose start = make_start_pose(palm.tree, config);
  const HandSkeleton hand = make_hand_skeleton(palm, tips);
  const HandMotion motion = find_hand_motion(model, palm, hand, start);

  // how it stands open
  const ExtendedHand extended = extend_hand(hand, motion, start.q);
  const Thumb thumb = find_thumb(hand, extended.postures, config);
  const OpenHand open = open_hand(hand, motion, extended, thumb.finger, palm.T_root_palm.rotation, config);
  const Digits digits = name_digits(hand, open, thumb.finger, config);

  Anatomy anatomy = describe_parts(palm, hand, tips, open, config);
  anatomy.hand = model.name;
  anatomy.thumb = thumb.finger;
  anatomy.middle = digits.middle;
  anatomy.handedness = digits.handedness;
  anatomy.findings = collect_findings(palm, tips, thumb, open, digits);
  anatomy.warnings = collect_warnings(palm, anatomy.findings);
  return anatomy;
}

}  // namespace uhas
