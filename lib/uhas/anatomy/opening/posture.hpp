// A finger as the rest of the hand sees it: where it is, where it points, which way it closes.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/opening/closing_side.hpp"

namespace uhas {

/// Places and unit vectors in P; `direction`, `axis` and `closing` are orthogonal to each other.
struct FingerPosture {
  Vector3d root, tip;
  Vector3d knuckle;    ///< origin of the first flexion joint
  Vector3d direction;  ///< first flexion joint to tip, in the plane of flexion
  Vector3d axis;       ///< flexion axis, turned such that a positive turn closes
  Vector3d closing;    ///< where the tip moves when the finger closes: axis x direction
};

FingerPosture measure_posture(const KinematicTree& tree, const FingerSkeleton& finger, const Flexion& flexion,
                              std::span<const double> q);

/// One element a finger.
std::vector<FingerPosture> measure_postures(const HandSkeleton& hand, std::span<const Flexion> flexions,
                                            std::span<const double> q);

}  // namespace uhas
