// Which finger is the middle one, and whether the hand is a right or a left one.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/opening/open_hand.hpp"

namespace uhas {

struct Digits {
  int middle = -1;  ///< index of the finger; -1 = none
  Handedness handedness = Handedness::none;
  std::vector<HandFinding> findings;  ///< "middle_finger" and "handedness"
};

/// @param thumb  index of the finger; -1 = none
/// Throws Error(invalid_config) for a middle finger that no joint tells, or that is the thumb.
Digits name_digits(const HandSkeleton& hand, const OpenHand& open, int thumb, const HandConfig& config = {});

/// Of three or four fingers beside a thumb, the middle one of the hand: the second from the thumb. -1 for other counts.
/// @param postures  one a finger, in the open pose
int find_middle_finger(std::span<const FingerPosture> postures, int thumb, Vector3d palm_normal);

}  // namespace uhas
