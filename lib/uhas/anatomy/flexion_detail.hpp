// How a finger bends: which of its joints flex it, to which side it closes, how it stands when extended.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uhas/anatomy/finger_pose_detail.hpp"

namespace uhas {

/// The joints that bend a finger.
struct Flexion {
  std::vector<int> positions;  ///< into `FingerAnatomy::joints`, root to tip; their axes are parallel
  bool sliding = false;        ///< a prismatic jaw: the one flexion joint shifts
  double closing_sign = 1;     ///< sign of the last one's motion that closes the finger
  double evidence = 0;         ///< 0..1: asymmetry of the range about the extended pose
};

/// Finds the flexion joints: those parallel to the last joint that moves the tip, with everything at mid range.
Flexion find_flexion(const Anatomy& anatomy, const FingerAnatomy& finger);

/// The first flexion joint's origin, everything at mid range.
Vector3d flexion_origin(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion);

/// Sets `closing_sign` and `evidence`: fingers close to the side with the larger range from the extended pose.
/// @param hand_center  mean of the fingers' flexion origins: an extended finger points away from it
void find_closing_side(const Anatomy& anatomy, const FingerAnatomy& finger, Vector3d hand_center, Flexion& flexion);

/// Fingers that stand side by side along parallel flexion axes close to the same side: they vote, by their evidence.
void agree_on_closing_side(const Anatomy& anatomy, std::span<Flexion> flexions);

/// Whether the finger's phalanges are straight with their joints at zero; nothing when it has no joint between phalanges
/// that stands free. `q` holds the values of the other joints.
std::optional<bool> is_straight_at_zero(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                                        std::vector<double> q);

/// What the rest of the hand knows about the angle between a finger's base and the palm.
struct BaseEvidence {
  bool zero_is_straight = false;  ///< the hand's fingers are straight at zero, so zero is where its designer opened it
  std::optional<Vector3d> slab;   ///< normal of the palm's slab, of either sign
};

/// Extends the finger in `q`: distal flexion joints straight, the first one at a zero near the open end of its range,
/// else straight with what comes before it, else square to the palm's slab, else just short of the open end; a side joint
/// before it has a say. Other joints keep their values.
/// Returns how far off the first one's value may be (rad, a standard error).
double extend_finger(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                     const BaseEvidence& evidence, std::span<double> q);

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
