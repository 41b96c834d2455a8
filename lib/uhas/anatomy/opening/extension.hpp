// How fingers stand when they are extended: straight, and at which angle to the palm
// (docs/method.md#anatomy, "The palm normal").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uhas/anatomy/opening/hand_motion.hpp"
#include "uhas/anatomy/opening/posture.hpp"

namespace uhas {

/// How well the first flexion joint's value in the extended pose is known.
struct BaseAngle {
  double error = 0;       ///< standard error (rad)
  bool is_guess = false;  ///< only the joint's range tells the value
};

/// What tells the angle between a finger's base and the palm.
struct BaseEvidence {
  bool zero_is_straight = false;  ///< the hand's fingers are straight at zero
  std::optional<PalmSlab> slab;
};

/// Extends the finger in `q`: distal flexion joints straight, the first one at a zero that its designer called
/// straight, else straight with what comes before it, else square to the palm's slab, else just short of the open end;
/// a side joint before it has a say. Other joints keep their values.
BaseAngle extend_finger(const KinematicTree& tree, const FingerSkeleton& finger, const Flexion& flexion,
                        const BaseEvidence& evidence, std::span<double> q);

/// A hand whose fingers are extended for the values of its side joints.
struct ExtendedHand {
  std::vector<double> q;
  std::vector<BaseAngle> bases;         ///< one a finger
  std::vector<FingerPosture> postures;  ///< one a finger, at `q`
};

/// Extends every finger from the pose `q`; what several fingers share stands in the middle of what they want, held
/// joints stay.
ExtendedHand extend_hand(const HandSkeleton& hand, const HandMotion& motion, std::vector<double> q);

}  // namespace uhas
