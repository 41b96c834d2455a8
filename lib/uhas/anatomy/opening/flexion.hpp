// Which joints bend a finger, and where they are straight (docs/method.md#anatomy, "Flexion").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uhas/anatomy/fingers/finger_pose.hpp"

namespace uhas {

/// A straight finger at zero may be this part shorter than the longest reach: fingertips are offset from
/// the joint's line.
inline constexpr double kStraightTolerance = 0.015;

/// The joints that bend a finger.
struct FlexionJoints {
  std::vector<int> positions;  ///< into `FingerSkeleton::joints`, root to tip; their axes are parallel
  bool sliding = false;        ///< a prismatic jaw: the one flexion joint shifts
};

/// Of the joints whose axes are parallel with everything at mid range, those that turn the tip most; of a finger whose
/// last joint slides, that one.
FlexionJoints find_flexion_joints(const KinematicTree& tree, const FingerSkeleton& finger);

/// The first flexion joint's origin, everything at mid range.
Vector3d flexion_origin(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion);

/// Signed rate of the finger's joint at `position` per unit of its variable, seen along the joint at `last`.
double flexion_rate(const KinematicTree& tree, const FingerSkeleton& finger, const FingerPose& pose, int position,
                    int last);

/// Straightens the flexion joints beyond the first: from the last inward, each variable puts the tip farthest from the
/// joint before those that it drives. Returns the variables that were set.
std::vector<int> straighten(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion,
                            std::span<double> q);

/// Whether the joint can stand at zero, but for rounding of its limits.
bool has_zero(const Joint& joint);

/// Whether the finger's phalanges are straight with their joints at zero; nothing when it has no joint between
/// phalanges that stands free. `q` holds the values of the other joints.
std::optional<bool> is_straight_at_zero(const KinematicTree& tree, const FingerSkeleton& finger,
                                        const FlexionJoints& flexion, std::vector<double> q);

}  // namespace uhas
