// Which finger is the thumb (docs/method.md#anatomy, "The thumb").
#pragma once

#include <span>

#include "uhas/anatomy/opening/posture.hpp"

namespace uhas {

struct Thumb {
  int finger = -1;      ///< -1 = none
  HandFinding finding;  ///< "thumb"
};

/// The finger that the config names; else the one whose removal leaves the others most alike, if they are alike and it
/// is different.
/// @param postures  one a finger, extended
/// Throws Error(invalid_config) for a joint that no finger has, or several.
Thumb find_thumb(const HandSkeleton& hand, std::span<const FingerPosture> postures, const HandConfig& config = {});

}  // namespace uhas
