// Words and lists, the same in JSON, tables and messages.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

const char* to_word(Handedness handedness);   ///< right, left, none
const char* to_word(JointClass joint_class);  ///< lateral, encompassing

/// Numbers of the slots that are owned.
std::vector<int> slot_numbers(const std::array<bool, kSlotCount>& slots);

/// `words` joined by `separator`.
std::string join(const std::vector<std::string>& words, const std::string& separator);

}  // namespace uhas::tools
