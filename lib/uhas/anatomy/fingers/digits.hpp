// Which finger is the thumb, where the palm normal points, which finger is the middle one.
#pragma once

#include <span>

#include "uhas/anatomy/opening/flexion.hpp"

namespace uhas {

struct Thumb {
  int finger = -1;        ///< -1 = no finger stands apart from the others
  double likeness = 0;    ///< -1..1: how alike the others are
  double difference = 0;  ///< 0..2: how much less they are like the thumb
  double confidence = 1;
};

/// The finger whose removal leaves the others most alike, if they are alike and it is different.
Thumb find_thumb(std::span<const FingerPosture> postures, double finger_length);

struct PalmNormal {
  Vector3d normal;
  bool opposing = false;  ///< the fingers close against each other, as a gripper's
  double coherence = 0;   ///< 0..1: how well the fingers agree on it
  Vector3d axis;          ///< mean flexion axis of fingers in a row, unit
  double spread = 0;      ///< standard error of their mean closing direction (rad)
};

/// The mean closing direction of fingers that stand in a row; for opposing fingers the axis that they close around.
PalmNormal find_palm_normal(std::span<const FingerPosture> postures, int thumb);

/// Of three or four fingers beside a thumb, the middle one of the hand: the second from the thumb. -1 for other counts.
/// @param thumb_posture  in the open pose, like the others
int find_middle_finger(std::span<const FingerPosture> postures, int thumb, Vector3d normal);

}  // namespace uhas
