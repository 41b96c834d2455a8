// Points along a finger whose motion stands for the finger's (paper, 'Sphere Observation Space';
// docs/method.md#observation).
#pragma once

#include <array>

#include "uhas/base/export.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

inline constexpr int kFingerPoints = 7;

/// A point that a joint carries.
struct FingerPoint {
  int joint = -1;    ///< index into the profile's joints
  Vector3d p_joint;  ///< in the joint's moved frame (m)
};

/// Points from the finger's root (first) to its fingertip (last), at equal arc lengths along the polyline through the
/// origins of the finger's joints in the open pose. Each is carried by the joint whose link has the correspondence
/// nearest to it in that pose, among the finger's own; on a finger without correspondences, by the joint that begins
/// its piece of the polyline.
/// @param profile  one that `validate_profile` accepts, @param finger  index into `profile.fingers`
UHAS_API std::array<FingerPoint, kFingerPoints> finger_points(const HandProfile& profile, int finger);

}  // namespace uhas
