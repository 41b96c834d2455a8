#include "uhas/anatomy/fingers/finger_pose.hpp"

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {

double mid_range(const Joint& joint) { return (joint.lower + joint.upper) / 2; }

std::vector<double> mid_pose(const KinematicTree& tree) {
  std::vector<double> q;
  for (const Joint& joint : tree.joints) q.push_back(mid_range(joint));
  apply_mimics(tree, q);
  return q;
}

FingerPose pose_finger(const KinematicTree& tree, const FingerSkeleton& finger, std::span<const double> q) {
  FingerPose pose;
  RigidTransformd T_palm_joint;
  for (int index : finger.joints) {
    const Joint& joint = tree.joints[index];
    const RigidTransformd T_palm_fixed = T_palm_joint * joint.T_parent_joint;
    pose.origin.push_back(T_palm_fixed.translation);
    pose.axis.push_back(T_palm_fixed.rotation * joint.axis);
    T_palm_joint = T_palm_fixed * joint_motion(joint, q[index]);
  }
  pose.tip = T_palm_joint * finger.p_tip_joint;
  return pose;
}

}  // namespace uhas
