// The mirror image of a hand profile.
#pragma once

#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

/// The hand seen in a mirror: y becomes -y in every frame, S included, and `mirrored` changes. The same joint values
/// give the mirror-image posture; everything canonical stays.
inline HandProfile mirror_image(HandProfile profile) {
  const auto flip = [](Vector3d a) { return Vector3d{a.x, -a.y, a.z}; };
  const auto flip_transform = [&](RigidTransformd T) {
    for (int i : {1, 3, 5, 7}) T.rotation.m[i] = -T.rotation.m[i];
    T.translation = flip(T.translation);
    return T;
  };
  profile.mirrored = !profile.mirrored;
  profile.handedness = profile.mirrored ? Handedness::left : Handedness::right;
  profile.T_root_palm = flip_transform(profile.T_root_palm);
  profile.T_palm_sphere = flip_transform(profile.T_palm_sphere);
  profile.palm_center_palm = flip(profile.palm_center_palm);
  for (Joint& joint : profile.tree.joints) {
    joint.T_parent_joint = flip_transform(joint.T_parent_joint);
    joint.axis = joint.kind == JointKind::prismatic ? flip(joint.axis) : -flip(joint.axis);
  }
  for (ProfileLink& link : profile.links) link.T_joint_link = flip_transform(link.T_joint_link);
  for (Correspondence& point : profile.correspondences) {
    point.p_link = flip(point.p_link);
    point.normal_link = flip(point.normal_link);
  }
  for (ProfileFinger& finger : profile.fingers) {
    finger.p_tip_link = flip(finger.p_tip_link);
    finger.pad_normal_link = flip(finger.pad_normal_link);
  }
  return profile;
}

}  // namespace uhas::test
