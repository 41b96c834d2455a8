// To which side the thumb closes, once the palm normal is known (docs/method.md#anatomy, "The thumb").
#pragma once

#include "uhas/anatomy/opening/extension.hpp"

namespace uhas {

/// A hand whose thumb closes to the side that was chosen for it, extended accordingly.
struct TurnedThumb {
  HandMotion motion;
  ExtendedHand extended;
  double margin = 1;  ///< 0..2: how clear the choice was; 1 without a thumb
};

/// The thumb closes to the side of its larger range, or to the other one when that faces the palm normal by more than
/// the ranges tell.
/// @param thumb  index of the finger; -1 = none
TurnedThumb turn_thumb(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                       Vector3d palm_normal);

}  // namespace uhas
