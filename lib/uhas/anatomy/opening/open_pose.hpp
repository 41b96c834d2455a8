// The open pose: fingers extended in the palm plane, pads toward the palm normal.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/fingers/digits.hpp"

namespace uhas {

/// Whether the search may turn the first flexion joints of fingers. While the palm normal itself is in question it must
/// not: they would follow any normal.
enum class Bases { held, searched };

/// Joint values that open the hand for the palm normal: fingers straight in the palm plane, pads along the normal. A
/// joint is put at zero, or else at mid range, where that costs next to nothing; side and roll joints of opposing
/// fingers keep their values.
/// @param flexions         one a finger
/// @param zero_is_neutral  the hand's designer put "open" at zero; else zero is a value like others
/// @param q                where the search begins, fingers extended
/// @param held             joints of the tree whose value in `q` stays
std::vector<double> find_open_pose(const Anatomy& anatomy, std::span<const Flexion> flexions, const PalmNormal& normal,
                                   bool zero_is_neutral, Bases bases, std::vector<double> q,
                                   const std::vector<bool>& held);

}  // namespace uhas
