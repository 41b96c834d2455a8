// The order in which the cascade solves a hand: which joints are one unknown, whom they move, which point they place.
#pragma once

#include <span>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// A point of a finger that a contact is sought for: the origin of a joint, or the fingertip.
struct ContactNode {
  int finger = -1;
  int joint = -1;  ///< the node is this joint's origin; -1 = the fingertip
};

/// One unknown: an independent joint together with its mimic followers.
struct CascadeStep {
  int joint = -1;            ///< the independent joint
  std::vector<int> driven;   ///< joints of fingers that turn with it (itself when a finger has it), in tree order
  std::vector<int> fingers;  ///< fingers that it moves
  std::vector<ContactNode>
      nodes;  ///< one a finger moved: the next encompassing joint that the step displaces, for the last one
              ///< and for a mimic group the fingertip (docs/method.md#wrap)
};

/// The encompassing unknowns in solving order: those that move several fingers first, then finger by finger,
/// root to tip.
/// @param finger_joints  joint indices root to tip, one list a finger
/// @param classes        one a joint of `tree`
/// @param q              [joint] the pose in which it is judged what a step displaces: q_open, for wrap and solver
///                       alike
std::vector<CascadeStep> plan_cascade(const KinematicTree& tree, std::span<const std::vector<int>> finger_joints,
                                      std::span<const JointClass> classes, std::span<const double> q);

}  // namespace uhas
