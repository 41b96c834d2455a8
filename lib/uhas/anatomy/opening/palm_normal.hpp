// Where the palm faces (docs/method.md#anatomy, "The palm normal").
#pragma once

#include <span>

#include "uhas/anatomy/opening/posture.hpp"

namespace uhas {

struct PalmNormal {
  Vector3d normal;        ///< outward, unit, in P
  bool opposing = false;  ///< the fingers close against each other, as a gripper's
  double coherence = 0;   ///< 0..1: how well the fingers agree on it
  Vector3d axis;          ///< mean flexion axis of fingers in a row, unit
  double spread = 0;      ///< standard error of their mean closing direction (rad)
};

/// The mean closing direction of fingers that stand in a row; for opposing fingers the axis that they close around.
/// @param thumb  index of the finger that does not count among a row; -1 = none
PalmNormal find_palm_normal(std::span<const FingerPosture> postures, int thumb);

}  // namespace uhas
