// Changes of a hand model that must not change what is found in it, but for what they say.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas::test {

/// The hand seen in a mirror: x becomes -x in every frame.
inline HandModel mirrored(HandModel model) {
  const auto flip = [](Vector3d p) { return Vector3d{-p.x, p.y, p.z}; };
  const auto flip_transform = [&](const RigidTransformd& T) {
    RigidTransformd result{T.rotation, flip(T.translation)};
    for (int i : {1, 2, 3, 6}) result.rotation.m[i] = -result.rotation.m[i];
    return result;
  };
  for (Joint& joint : model.tree.joints) {
    joint.T_parent_joint = flip_transform(joint.T_parent_joint);
    joint.axis = joint.kind == JointKind::prismatic ? flip(joint.axis) : -flip(joint.axis);
  }
  for (ModelLink& link : model.links) {
    link.T_joint_link = flip_transform(link.T_joint_link);
    for (Vector3d& vertex : link.mesh.vertices) vertex = flip(vertex);
    for (auto& triangle : link.mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return model;
}

/// Every length times `scale`.
inline HandModel scaled(HandModel model, double scale) {
  for (Joint& joint : model.tree.joints) {
    joint.T_parent_joint.translation = scale * joint.T_parent_joint.translation;
    if (joint.kind != JointKind::prismatic) continue;
    joint.lower *= scale;
    joint.upper *= scale;
    joint.mimic_offset *= scale;
  }
  for (ModelLink& link : model.links) {
    link.T_joint_link.translation = scale * link.T_joint_link.translation;
    for (Vector3d& vertex : link.mesh.vertices) vertex = scale * vertex;
  }
  return model;
}

/// A rotation drawn uniformly, with a shift of some hand sizes.
inline RigidTransformd random_pose(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Vector3d x = normalized(Vector3d{normal(random), normal(random), normal(random)});
  const Vector3d y = normalized(orthogonal_part(Vector3d{normal(random), normal(random), normal(random)}, x));
  return {Rotationd::from_columns(x, y, cross(x, y)),
          {0.3 * normal(random), 0.3 * normal(random), 0.3 * normal(random)}};
}

/// The root frame elsewhere: `T_new_old` maps old root coordinates to new ones.
inline HandModel with_moved_root(HandModel model, const RigidTransformd& T_new_old) {
  for (Joint& joint : model.tree.joints)
    if (joint.parent < 0) joint.T_parent_joint = T_new_old * joint.T_parent_joint;
  for (ModelLink& link : model.links)
    if (link.joint < 0) link.T_joint_link = T_new_old * link.T_joint_link;
  return model;
}

/// The chosen joints turn the other way: axis, limits and couplings change sign, the motions stay.
inline HandModel with_flipped_axes(HandModel model, const std::vector<bool>& flipped) {
  std::vector<Joint>& joints = model.tree.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    Joint& joint = joints[i];
    if (joint.mimic_master >= 0 && flipped[joint.mimic_master]) joint.mimic_multiplier = -joint.mimic_multiplier;
    if (!flipped[i]) continue;
    joint.axis = -joint.axis;
    std::swap(joint.lower, joint.upper);
    joint.lower = -joint.lower;
    joint.upper = -joint.upper;
    joint.mimic_multiplier = -joint.mimic_multiplier;
    joint.mimic_offset = -joint.mimic_offset;
  }
  return model;
}

/// Every zero elsewhere: joint i reads `offset[i]` where it read 0; followers keep theirs.
inline HandModel with_moved_zeros(HandModel model, const std::vector<double>& offset) {
  std::vector<Joint>& joints = model.tree.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    Joint& joint = joints[i];
    if (joint.mimic_master >= 0) {
      joint.mimic_offset -= joint.mimic_multiplier * offset[joint.mimic_master];
      continue;
    }
    // q_new = q_old + offset, so the frame before the joint takes the motion back
    const RigidTransformd back = joint.kind == JointKind::prismatic
                                     ? RigidTransformd{{}, -offset[i] * joint.axis}
                                     : RigidTransformd{Rotationd::about(joint.axis, -offset[i]), {}};
    joint.T_parent_joint = joint.T_parent_joint * back;
    joint.lower += offset[i];
    joint.upper += offset[i];
  }
  return model;
}

/// The frame of every joint, and of every link fixed behind it, turned at random; the link frames of movable joints
/// stay those joints' frames, as in a URDF.
inline HandModel with_turned_frames(HandModel model, std::mt19937_64& random) {
  std::vector<Rotationd> R_old_new;
  for (Joint& joint : model.tree.joints) {
    R_old_new.push_back(random_pose(random).rotation);
    joint.T_parent_joint = joint.T_parent_joint * RigidTransformd{R_old_new.back(), {}};
    joint.axis = R_old_new.back().transposed() * joint.axis;
    if (joint.parent >= 0)
      joint.T_parent_joint = RigidTransformd{R_old_new[joint.parent].transposed(), {}} * joint.T_parent_joint;
  }
  for (ModelLink& link : model.links) {
    if (link.joint < 0) continue;
    const bool is_joint_frame = link.parent_link < 0 || model.links[link.parent_link].joint != link.joint;
    const Rotationd R_link = is_joint_frame ? R_old_new[link.joint] : random_pose(random).rotation;
    link.T_joint_link =
        RigidTransformd{R_old_new[link.joint].transposed(), {}} * link.T_joint_link * RigidTransformd{R_link, {}};
    for (Vector3d& vertex : link.mesh.vertices) vertex = R_link.transposed() * vertex;
  }
  return model;
}

/// Siblings in the opposite order, as if every name sorted the other way.
inline HandModel with_reversed_siblings(const HandModel& model) {
  std::vector<int> old_links;  // in their new order: depth first from the root, last sibling first
  std::vector<int> stack = {0};
  while (!stack.empty()) {
    const int link = stack.back();
    stack.pop_back();
    old_links.push_back(link);
    for (std::size_t child = 0; child < model.links.size(); ++child)
      if (model.links[child].parent_link == link) stack.push_back(static_cast<int>(child));
  }
  std::vector<int> new_link(model.links.size()), new_joint(model.tree.joints.size(), -1), old_joints;
  for (std::size_t i = 0; i < old_links.size(); ++i) {
    new_link[old_links[i]] = static_cast<int>(i);
    const int joint = model.links[old_links[i]].joint;
    if (joint < 0 || new_joint[joint] >= 0) continue;
    new_joint[joint] = static_cast<int>(old_joints.size());
    old_joints.push_back(joint);
  }
  HandModel result = model;
  const auto renumber = [](int index, const std::vector<int>& map) { return index < 0 ? index : map[index]; };
  for (std::size_t i = 0; i < old_links.size(); ++i) {
    result.links[i] = model.links[old_links[i]];
    result.links[i].parent_link = renumber(result.links[i].parent_link, new_link);
    result.links[i].joint = renumber(result.links[i].joint, new_joint);
  }
  for (std::size_t i = 0; i < old_joints.size(); ++i) {
    result.tree.joints[i] = model.tree.joints[old_joints[i]];
    result.tree.joints[i].parent = renumber(result.tree.joints[i].parent, new_joint);
    result.tree.joints[i].mimic_master = renumber(result.tree.joints[i].mimic_master, new_joint);
  }
  return result;
}

}  // namespace uhas::test
