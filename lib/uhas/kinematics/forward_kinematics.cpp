#include "uhas/kinematics/forward_kinematics.hpp"

#include <algorithm>

namespace uhas {

RigidTransformd joint_motion(const Joint& joint, double q) {
  if (joint.kind == JointKind::prismatic) return {{}, q * joint.axis};
  return {Rotationd::about(joint.axis, q), {}};
}

namespace {

void place(const KinematicTree& tree, std::span<const double> q, std::size_t i,
           std::span<RigidTransformd> T_root_joint) {
  const Joint& joint = tree.joints[i];
  const RigidTransformd T_parent_moved = joint.T_parent_joint * joint_motion(joint, q[i]);
  T_root_joint[i] = joint.parent < 0 ? T_parent_moved : T_root_joint[joint.parent] * T_parent_moved;
}

}  // namespace

void forward_kinematics(const KinematicTree& tree, std::span<const double> q, std::span<RigidTransformd> T_root_joint) {
  for (std::size_t i = 0; i < tree.joints.size(); ++i) place(tree, q, i, T_root_joint);
}

void forward_kinematics(const KinematicTree& tree, std::span<const double> q, std::span<const int> joints,
                        std::span<RigidTransformd> T_root_joint) {
  for (int i : joints) place(tree, q, i, T_root_joint);
}

std::vector<RigidTransformd> link_poses(const KinematicTree& tree, std::span<const ProfileLink> links,
                                        std::span<const double> q) {
  std::vector<RigidTransformd> T_root_joint(tree.joints.size()), T_root_link;
  forward_kinematics(tree, q, T_root_joint);
  for (const ProfileLink& link : links)
    T_root_link.push_back(link.joint < 0 ? link.T_joint_link : T_root_joint[link.joint] * link.T_joint_link);
  return T_root_link;
}

double clamp_to_limits(const Joint& joint, double q) { return std::clamp(q, joint.lower, joint.upper); }

}  // namespace uhas
