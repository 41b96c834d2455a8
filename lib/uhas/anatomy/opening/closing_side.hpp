// To which side a finger closes (docs/method.md#anatomy, "Flexion").
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/opening/flexion.hpp"

namespace uhas {

struct ClosingSide {
  double sign = 1;      ///< of the last flexion joint's motion that closes the finger
  double evidence = 0;  ///< 0..1: asymmetry of the range about the extended pose
};

/// How a finger bends.
struct Flexion : FlexionJoints {
  ClosingSide closing;
};

/// The side with the larger range from the extended pose; of a jaw that of the hand's middle.
/// @param hand_center       mean of the fingers' flexion origins: an extended finger points away from it
/// @param zero_is_straight  the hand's fingers are straight at zero
ClosingSide find_closing_side(const KinematicTree& tree, const FingerSkeleton& finger, const FlexionJoints& flexion,
                              Vector3d hand_center, bool zero_is_straight);

/// Fingers that stand side by side along parallel flexion axes close to the same side: they vote, by their evidence.
/// One element a finger, in and out.
std::vector<ClosingSide> agree_on_closing_side(const HandSkeleton& hand, std::span<const Flexion> flexions);

}  // namespace uhas
