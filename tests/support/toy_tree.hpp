// Trees of joints built one by one, every joint frame parallel to the root at q = 0, so that positions can be
// told by hand.
#pragma once

#include <string>

#include "uhas/base/kinematic_tree.hpp"

namespace uhas::test {

/// Origin of a joint in the root frame at q = 0; the root's own for -1.
inline Vector3d origin_at_zero(const KinematicTree& tree, int joint) {
  Vector3d origin;
  for (int i = joint; i >= 0; i = tree.joints[i].parent) origin += tree.joints[i].T_parent_joint.translation;
  return origin;
}

/// A revolute joint `j<index>` at `origin` (root frame, at q = 0); returns its index.
inline int add_hinge(KinematicTree& tree, int parent, Vector3d origin, Vector3d axis, double lower, double upper) {
  Joint joint;
  joint.name = "j" + std::to_string(tree.joints.size());
  joint.parent = parent;
  joint.T_parent_joint = {{}, origin - origin_at_zero(tree, parent)};
  joint.axis = axis;
  joint.lower = lower;
  joint.upper = upper;
  tree.joints.push_back(joint);
  return static_cast<int>(tree.joints.size()) - 1;
}

/// A prismatic joint, placed like a hinge.
inline int add_slide(KinematicTree& tree, int parent, Vector3d origin, Vector3d axis, double lower, double upper) {
  const int joint = add_hinge(tree, parent, origin, axis, lower, upper);
  tree.joints[joint].kind = JointKind::prismatic;
  return joint;
}

/// A hinge that turns `multiplier` times as far as `master`.
inline int add_follower(KinematicTree& tree, int parent, Vector3d origin, Vector3d axis, int master,
                        double multiplier) {
  const int joint = add_hinge(tree, parent, origin, axis, -3, 3);
  tree.joints[joint].mimic_master = master;
  tree.joints[joint].mimic_multiplier = multiplier;
  return joint;
}

}  // namespace uhas::test
