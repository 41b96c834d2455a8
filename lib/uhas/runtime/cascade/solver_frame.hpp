// The frames of the solver: S in sphere radii at the root, and joints whose z is their axis.
#pragma once

#include "uhas/kinematics/axis_frame.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// The solver's frame of a joint in the profile's: turned about the joint's origin until its z is the axis.
inline RigidTransformd solver_frame(const Joint& joint) { return {axis_frame(joint), {}}; }

/// Frame of the profile's joint (or, for -1, of the palm) in the solver's joint (or S), metres.
inline RigidTransformd solver_from_profile(const HandProfile& profile, int joint) {
  return joint < 0 ? profile.T_palm_sphere.inverse() : solver_frame(profile.tree.joints[joint]).inverse();
}

/// A point of a link (metres, link frame) in the solver's frame of the joint that moves the link, sphere radii.
inline Vector3d point_in_solver(const HandProfile& profile, const ProfileLink& link, Vector3d p_link) {
  const Vector3d p = solver_from_profile(profile, link.joint) * link.T_joint_link * p_link;
  return p / profile.radius;
}

}  // namespace uhas
