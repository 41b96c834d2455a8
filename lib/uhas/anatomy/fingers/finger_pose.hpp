// A finger in a pose: where its joints and its tip are. All vectors are in P.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/fingers/hand_skeleton.hpp"

namespace uhas {

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
