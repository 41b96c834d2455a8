// Forward kinematics of a tree of joints: the one implementation of the project, for stages and runtime alike.
#pragma once

#include <span>
#include <vector>

#include "uhas/base/kinematic_tree.hpp"
#include "uhas/kinematics/mimics.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Transform of a joint's moved frame relative to its frame at q = 0: a turn about, or a shift along, the axis.
RigidTransformd joint_motion(const Joint& joint, double q);

/// `T_root_joint[i]` = joint i's moved frame in the tree's root frame. Both spans hold one element a joint of `tree`;
/// `q` is taken as it is (see `apply_mimics`).
void forward_kinematics(const KinematicTree& tree, std::span<const double> q, std::span<RigidTransformd> T_root_joint);

/// The same for `joints` alone, increasing indices that hold the parent of each, if it has one.
void forward_kinematics(const KinematicTree& tree, std::span<const double> q, std::span<const int> joints,
                        std::span<RigidTransformd> T_root_joint);

/// Frames of `links` in the tree's root frame. `q`: one value a joint of `tree`, taken as it is. Allocates.
std::vector<RigidTransformd> link_poses(const KinematicTree& tree, std::span<const ProfileLink> links,
                                        std::span<const double> q);

/// `q` held within the joint's limits.
double clamp_to_limits(const Joint& joint, double q);

}  // namespace uhas
