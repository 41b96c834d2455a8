// A finger in a pose: where its joints and its tip are. All vectors are in P.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/fingers/hand_skeleton.hpp"

namespace uhas {

/// Independent joint that decides the value of `joint`: its mimic master, or itself.
int variable_of(const KinematicTree& tree, int joint);

/// Sets an independent joint and lets its followers follow.
void set_joint(const KinematicTree& tree, int variable, double value, std::span<double> q);

/// The middle of a joint's range.
double mid_range(const Joint& joint);

/// Every independent joint at the middle of its range.
std::vector<double> mid_pose(const KinematicTree& tree);

/// One finger in a pose.
struct FingerPose {
  std::vector<Vector3d> origin, axis;  ///< one a joint, root to tip; axes are unit
  Vector3d tip;
};
FingerPose pose_finger(const KinematicTree& tree, const FingerSkeleton& finger, std::span<const double> q);

}  // namespace uhas
