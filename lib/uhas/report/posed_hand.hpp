// Where the links of a hand stand, as pictures need it.
#pragma once

#include <span>
#include <vector>

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {

/// Frames of all links in S (m).
inline std::vector<RigidTransformd> link_poses_in_sphere(const HandProfile& profile, std::span<const double> q) {
  const RigidTransformd T_sphere_palm = profile.T_palm_sphere.inverse();
  std::vector<RigidTransformd> poses = link_poses(profile.tree, profile.links, q);
  for (RigidTransformd& pose : poses) pose = T_sphere_palm * pose;
  return poses;
}

}  // namespace uhas
