// The open pose: fingers extended in the palm plane, pads toward the palm normal
// (docs/method.md#anatomy, "The open pose").
#pragma once

#include <vector>

#include "uhas/anatomy/opening/extension.hpp"
#include "uhas/anatomy/opening/palm_normal.hpp"

namespace uhas {

/// Whether the search may turn the first flexion joints of fingers. While the palm normal itself is in question it must
/// not: they would follow any normal.
enum class Bases { held, searched };

/// Joint values that open the extended hand for the palm normal: fingers straight in the palm plane, pads along the
/// normal. A joint is put at zero, where zeros say something, or else at mid range, where that costs next to nothing;
/// side and roll joints of opposing fingers keep their values, and so do held joints.
/// @param thumb  index of the finger that need not lie as flat; -1 = none
std::vector<double> find_open_pose(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended,
                                   int thumb, const PalmNormal& normal, Bases bases);

}  // namespace uhas
