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

/// Narrows each master's limits until its followers stay within theirs too; a follower that no master value
/// suits is reported.
void narrow_masters(Anatomy& anatomy) {
  for (const Joint& follower : anatomy.tree.joints) {
    if (follower.mimic_master < 0 || follower.mimic_multiplier == 0) continue;
    Joint& master = anatomy.tree.joints[follower.mimic_master];
    const auto [low, high] = std::minmax({(follower.lower - follower.mimic_offset) / follower.mimic_multiplier,
                                          (follower.upper - follower.mimic_offset) / follower.mimic_multiplier});
    if (std::max(master.lower, low) < std::min(master.upper, high)) {
      master.lower = std::max(master.lower, low);
      master.upper = std::min(master.upper, high);
    } else {
      anatomy.warnings.push_back("joint '" + follower.name + "' leaves its limits wherever '" + master.name +
                                 "', which it mimics, stands");
    }
  }
}

}  // namespace

Anatomy make_palm_tree(const HandModel& model, const FingerChains& found, const HandConfig& config) {
  const std::vector<Joint>& joints = model.tree.joints;
  const ModelLink& palm = model.links[found.palm_link];
  const std::vector<bool> selected = select_joints(model, found);
  const std::vector<double> q_zero = clipped_zero(model.tree);
  std::vector<RigidTransformd> T_root_joint(joints.size());
  forward_kinematics(model.tree, q_zero, T_root_joint);

  Anatomy anatomy;
  anatomy.hand = model.name;
  anatomy.root_link = model.links.front().name;
  anatomy.palm_link = palm.name;
  anatomy.T_root_palm = found.palm_group < 0 ? palm.T_joint_link : T_root_joint[found.palm_group] * palm.T_joint_link;
  const RigidTransformd T_palm_root = anatomy.T_root_palm.inverse();
  const RigidTransformd T_palm_group = palm.T_joint_link.inverse();

  std::vector<int> tree_index(joints.size(), -1);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!selected[i]) {
      anatomy.other_joints.push_back(joints[i].name);
      continue;
    }
    tree_index[i] = static_cast<int>(anatomy.tree.joints.size());
    Joint joint = joints[i];
    // Joints left out are folded into the next one further out; the palm's own joint is where P begins.
    int carrier = joint.parent;
    while (carrier >= 0 && carrier != found.palm_group && !selected[carrier]) {
      joint.T_parent_joint =
          joints[carrier].T_parent_joint * joint_motion(joints[carrier], q_zero[carrier]) * joint.T_parent_joint;
      carrier = joints[carrier].parent;
    }
    const bool on_palm = carrier == found.palm_group;
    if (on_palm)
      joint.T_parent_joint = T_palm_group * joint.T_parent_joint;
    else if (carrier < 0)
      joint.T_parent_joint = T_palm_root * joint.T_parent_joint;
    joint.parent = on_palm || carrier < 0 ? -1 : tree_index[carrier];
    if (joint.kind == JointKind::continuous) {
      joint.lower = -std::numbers::pi;
      joint.upper = std::numbers::pi;
    }
    anatomy.tree.joints.push_back(std::move(joint));
  }
  for (Joint& joint : anatomy.tree.joints)
    if (joint.mimic_master >= 0) joint.mimic_master = tree_index[joint.mimic_master];
  narrow_joint_limits(anatomy.tree, config);
  narrow_masters(anatomy);

  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const ModelLink& link = model.links[i];
    const bool on_palm = link.joint == found.palm_group;
    if (!on_palm && (link.joint < 0 || tree_index[link.joint] < 0)) continue;
    const RigidTransformd T_joint_link = on_palm ? T_palm_group * link.T_joint_link : link.T_joint_link;
    anatomy.links.push_back({link.name, on_palm ? -1 : tree_index[link.joint], T_joint_link});
    anatomy.model_links.push_back(static_cast<int>(i));
  }

  for (const std::vector<int>& chain : found.chains) {
    FingerAnatomy& finger = anatomy.fingers.emplace_back();
    for (int joint : chain) finger.joints.push_back(tree_index[joint]);
  }
  return anatomy;
}

}  // namespace uhas
