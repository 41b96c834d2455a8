#include "uhas/anatomy/palm/palm_tree.hpp"

#include <algorithm>
#include <numbers>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// True for the joints of fingers and the masters that they follow.
std::vector<bool> select_joints(const HandModel& model, const FingerChains& found) {
  std::vector<bool> selected(model.tree.joints.size(), false);
  for (const std::vector<int>& chain : found.chains) {
    for (int joint : chain) {
      selected[joint] = true;
      if (const int master = model.tree.joints[joint].mimic_master; master >= 0) selected[master] = true;
    }
  }
  return selected;
}

/// Every joint at zero, clipped to its limits.
std::vector<double> clipped_zero(const KinematicTree& tree) {
  std::vector<double> q;
  for (const Joint& joint : tree.joints) q.push_back(clamp_to_limits(joint, 0.0));
  apply_mimics(tree, q);
  return q;
}

/// Index in the palm's tree of each joint of the model; -1 = left out.
std::vector<int> number_selected(const std::vector<bool>& selected) {
  std::vector<int> index;
  int count = 0;
  for (const bool is_selected : selected) index.push_back(is_selected ? count++ : -1);
  return index;
}

/// The root link's frame to P, with the joints of the model at `q`.
RigidTransformd root_to_palm(const HandModel& model, const FingerChains& found, const std::vector<double>& q) {
  const RigidTransformd& T_group_palm = model.links[found.palm_link].T_joint_link;
  if (found.palm_group < 0) return T_group_palm;
  std::vector<RigidTransformd> T_root_joint(q.size());
  forward_kinematics(model.tree, q, T_root_joint);
  return T_root_joint[found.palm_group] * T_group_palm;
}

/// The joints that have an index in the palm's tree, rooted in P; the others stand at `q`.
KinematicTree fold_joints(const HandModel& model, const FingerChains& found, const std::vector<int>& tree_index,
                          const std::vector<double>& q, const RigidTransformd& T_root_palm) {
  const std::vector<Joint>& joints = model.tree.joints;
  const RigidTransformd T_palm_root = T_root_palm.inverse();
  const RigidTransformd T_palm_group = model.links[found.palm_link].T_joint_link.inverse();
  KinematicTree tree;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (tree_index[i] < 0) continue;
    Joint joint = joints[i];

    // joints left out are folded into the next one further out
    int carrier = joint.parent;
    while (carrier >= 0 && carrier != found.palm_group && tree_index[carrier] < 0) {
      joint.T_parent_joint =
          joints[carrier].T_parent_joint * joint_motion(joints[carrier], q[carrier]) * joint.T_parent_joint;
      carrier = joints[carrier].parent;
    }

    // P begins where the palm's own joint carries it; a master that stands beside the palm hangs on the root
    const bool on_palm = carrier == found.palm_group;
    if (on_palm)
      joint.T_parent_joint = T_palm_group * joint.T_parent_joint;
    else if (carrier < 0)
      joint.T_parent_joint = T_palm_root * joint.T_parent_joint;
    joint.parent = on_palm || carrier < 0 ? -1 : tree_index[carrier];
    if (joint.mimic_master >= 0) joint.mimic_master = tree_index[joint.mimic_master];

    // a continuous joint has no limits: until the open pose is known, half a turn to both sides of zero
    if (joint.kind == JointKind::continuous) {
      joint.lower = -std::numbers::pi;
      joint.upper = std::numbers::pi;
    }
    tree.joints.push_back(std::move(joint));
  }
  return tree;
}

/// Narrows each master's limits until its followers stay within theirs too; returns a warning for every follower that
/// no master value suits.
std::vector<std::string> narrow_masters(KinematicTree& tree) {
  std::vector<std::string> warnings;
  for (const Joint& follower : tree.joints) {
    if (follower.mimic_master < 0 || follower.mimic_multiplier == 0) continue;
    Joint& master = tree.joints[follower.mimic_master];
    const auto [low, high] = std::minmax({(follower.lower - follower.mimic_offset) / follower.mimic_multiplier,
                                          (follower.upper - follower.mimic_offset) / follower.mimic_multiplier});
    if (std::max(master.lower, low) < std::min(master.upper, high)) {
      master.lower = std::max(master.lower, low);
      master.upper = std::min(master.upper, high);
    } else {
      warnings.push_back("joint '" + follower.name + "' leaves its limits wherever '" + master.name +
                         "', which it mimics, stands");
    }
  }
  return warnings;
}

std::vector<HandFinding> explain(const PalmTree& palm, const FingerChains& found, const HandConfig& config) {
  std::vector<HandFinding> findings;
  if (!config.joint_limits.empty())
    findings.push_back({"joint_limits", count_joints(config.joint_limits.size()) + " narrowed", kStatedInConfig, 1});

  if (config.palm_link)
    findings.push_back({"palm_link", palm.palm_link, kStatedInConfig, 1});
  else
    findings.push_back({"palm_link", palm.palm_link,
                        "the lowest group of links in which all long chains of joints meet", found.palm_margin});

  const std::string fingers = std::to_string(palm.chains.size()) + " fingers";
  std::string reason = "branches of movable joints from the palm, each as long as a finger";
  if (!palm.other_joints.empty())
    reason += "; " + std::to_string(palm.other_joints.size()) + " other joints are above the palm or too short";
  if (!config.fingers.empty())
    findings.push_back({"fingers", fingers, kStatedInConfig, 1});
  else
    findings.push_back({"fingers", fingers, reason, 0.4 + 0.6 * found.chain_margin});
  return findings;
}

}  // namespace

PalmTree make_palm_tree(const HandModel& model, const FingerChains& found, const HandConfig& config) {
  PalmTree palm;
  palm.root_link = model.links.front().name;
  palm.palm_link = model.links[found.palm_link].name;

  // the joints
  const std::vector<int> tree_index = number_selected(select_joints(model, found));
  const std::vector<double> q_zero = clipped_zero(model.tree);
  palm.T_root_palm = root_to_palm(model, found, q_zero);
  palm.tree = fold_joints(model, found, tree_index, q_zero, palm.T_root_palm);
  for (std::size_t i = 0; i < tree_index.size(); ++i)
    if (tree_index[i] < 0) palm.other_joints.push_back(model.tree.joints[i].name);
  narrow_joint_limits(palm.tree, config);
  palm.warnings = narrow_masters(palm.tree);

  // the links: those of the palm's rigid group, in P, and those that a joint of the tree carries
  const RigidTransformd T_palm_group = model.links[found.palm_link].T_joint_link.inverse();
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const ModelLink& link = model.links[i];
    const bool on_palm = link.joint == found.palm_group;
    if (!on_palm && (link.joint < 0 || tree_index[link.joint] < 0)) continue;
    const RigidTransformd T_joint_link = on_palm ? T_palm_group * link.T_joint_link : link.T_joint_link;
    palm.links.push_back({link.name, on_palm ? -1 : tree_index[link.joint], T_joint_link});
    palm.model_links.push_back(static_cast<int>(i));
  }

  // the fingers
  for (const std::vector<int>& chain : found.chains) {
    std::vector<int>& joints = palm.chains.emplace_back();
    for (int joint : chain) joints.push_back(tree_index[joint]);
  }
  palm.findings = explain(palm, found, config);
  return palm;
}

}  // namespace uhas
