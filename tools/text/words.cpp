#include "text/words.hpp"

namespace uhas::tools {

const char* to_word(Handedness handedness) {
  switch (handedness) {
    case Handedness::right: return "right";
    case Handedness::left: return "left";
    case Handedness::none: break;
  }
  return "none";
}

const char* to_word(JointClass joint_class) { return joint_class == JointClass::lateral ? "lateral" : "encompassing"; }

std::vector<int> slot_numbers(const std::array<bool, kSlotCount>& slots) {
  std::vector<int> numbers;
  for (int slot = 0; slot < kSlotCount; ++slot)
    if (slots[slot]) numbers.push_back(slot);
  return numbers;
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i > 0 ? separator : "") + words[i];
  return text;
}

}  // namespace uhas::tools
