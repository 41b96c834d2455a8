// How a finger bends: which of its joints flex it, to which side it closes, how it stands when extended.
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
struct Flexion {
  std::vector<int> positions;  ///< into `FingerAnatomy::joints`, root to tip; their axes are parallel
  bool sliding = false;        ///< a prismatic jaw: the one flexion joint shifts
  double closing_sign = 1;     ///< sign of the last one's motion that closes the finger
  double evidence = 0;         ///< 0..1: asymmetry of the range about the extended pose
  double base_error = 0;       ///< of the first one's value in the extended pose (rad, a standard error)
  bool base_is_guess = false;  ///< only the joint's range tells that value
};

/// Finds the flexion joints: of the joints whose axes are parallel with everything at mid range, those that turn the
/// tip most; of a finger whose last joint slides, that one.
Flexion find_flexion(const Anatomy& anatomy, const FingerAnatomy& finger);

/// The first flexion joint's origin, everything at mid range.
Vector3d flexion_origin(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion);

/// Signed rate of the finger's joint at `position` per unit of its variable, seen along the joint at `last`.
double flexion_rate(const Anatomy& anatomy, const FingerAnatomy& finger, const FingerPose& pose, int position,
                    int last);

/// Straightens the flexion joints beyond the first: from the last inward, each variable puts the tip farthest from the
/// joint before those that it drives. Returns the variables that were set.
std::vector<int> straighten(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                            std::span<double> q);

/// Whether the joint can stand at zero, but for rounding of its limits.
bool has_zero(const Joint& joint);

/// Sets `closing_sign` and `evidence`: fingers close to the side with the larger range from the extended pose.
/// @param hand_center       mean of the fingers' flexion origins: an extended finger points away from it
/// @param zero_is_straight  the hand's fingers are straight at zero
void find_closing_side(const Anatomy& anatomy, const FingerAnatomy& finger, Vector3d hand_center, bool zero_is_straight,
                       Flexion& flexion);

/// Fingers that stand side by side along parallel flexion axes close to the same side: they vote, by their evidence.
void agree_on_closing_side(const Anatomy& anatomy, std::span<Flexion> flexions);

/// Whether the finger's phalanges are straight with their joints at zero; nothing when it has no joint between
/// phalanges that stands free. `q` holds the values of the other joints.
std::optional<bool> is_straight_at_zero(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                                        std::vector<double> q);

/// A finger as the rest of the hand sees it; unit vectors, orthogonal to each other.
struct FingerPosture {
  Vector3d root, tip;
  Vector3d knuckle;    ///< origin of the first flexion joint
  Vector3d direction;  ///< first flexion joint to tip, in the plane of flexion
  Vector3d axis;       ///< flexion axis, turned such that a positive turn closes
  Vector3d closing;    ///< where the tip moves when the finger closes: axis x direction
};
FingerPosture measure_posture(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                              std::span<const double> q, FingerPose& scratch);

}  // namespace uhas
