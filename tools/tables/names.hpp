// Words for the values of enumerations, the same in JSON and in tables.
#pragma once

#include <array>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

const char* to_word(Handedness handedness);   ///< right, left, none
const char* to_word(JointClass joint_class);  ///< lateral, encompassing

/// Numbers of the slots that are owned.
std::vector<int> slot_numbers(const std::array<bool, kSlotCount>& slots);

}  // namespace uhas::tools
