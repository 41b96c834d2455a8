// Which action slots a finger owns (docs/method.md#slots).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

struct SlotAssignment {
  std::vector<std::array<bool, kSlotCount>> slots;  ///< one a finger; every slot has an owner
  std::vector<int> own_slot;                        ///< one a finger: the slot that it stands in, no other finger's
  std::vector<std::string> names;                   ///< one a finger
};

/// @param azimuth       canonical azimuth of each open fingertip; 2 to 5 fingers
/// @param place         canonical azimuth of each finger's middle: fingers keep this order, for neighbouring tips may cross
/// @param thumb_finger  the finger that owns slot 4
/// @param has_thumb     it is a thumb indeed; else it only stands apart
/// @param merge_pinky   of five fingers, slots 0 and 1 are averaged for ring and pinky
SlotAssignment assign_slots(std::span<const double> azimuth, std::span<const double> place, int thumb_finger,
                            bool has_thumb, bool merge_pinky);

}  // namespace uhas
