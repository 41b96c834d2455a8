// A tree of movable joints: the one kinematic description that model, stages, profile and runtime share.
#pragma once

#include <string>
#include <vector>

#include "uhas/base/rigid_transform.hpp"

namespace uhas {

/// The numbers are those of the profile format.
enum class JointKind : int { revolute = 0, continuous = 1, prismatic = 2 };

/// One movable joint. Fixed joints are folded into `T_parent_joint` and into the poses of links.
/// A continuous joint has lower = -infinity and upper = +infinity in a model and finite bounds in a hand profile.
struct Joint {
  std::string name;
  JointKind kind = JointKind::revolute;
  int parent = -1;  ///< index of the joint that carries this one, below its own index; -1 = the tree's root frame
  RigidTransformd T_parent_joint;  ///< this joint's frame at q = 0 in its parent's MOVED frame (metres)
  Vector3d axis{0, 0, 1};          ///< unit vector in the joint frame
  double lower = 0, upper = 0;     ///< position limits (rad, or m for a prismatic joint)
  double velocity_limit = 0;       ///< rad/s or m/s; 0 = not stated
  int mimic_master = -1;           ///< index of an independent joint of the same tree; -1 = independent
  double mimic_multiplier = 1;     ///< q = multiplier * q_master + offset (chains of mimics are flattened)
  double mimic_offset = 0;

  friend bool operator==(const Joint&, const Joint&) = default;
};

/// Joints in an order in which every parent precedes its children.
struct KinematicTree {
  std::vector<Joint> joints;

  friend bool operator==(const KinematicTree&, const KinematicTree&) = default;
};

}  // namespace uhas
