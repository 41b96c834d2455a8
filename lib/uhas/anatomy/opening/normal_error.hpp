// How far off the palm normal may be, by what its witnesses say of each other
// (docs/method.md#anatomy, "Its confidence").
#pragma once

#include "uhas/anatomy/opening/extension.hpp"
#include "uhas/anatomy/opening/palm_normal.hpp"

namespace uhas {

/// Standard error of the palm normal (rad).
/// @param extended  the hand when it is open
/// @param thumb     index of the finger that is no witness of a row's normal; -1 = none
double palm_normal_error(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                         const PalmNormal& found);

}  // namespace uhas
