// A hand reduced to joints and fingertips: all that is needed to pose its fingers. Everything is in P.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/fingers/fingertip.hpp"

namespace uhas {

/// One finger of a tree of joints.
struct FingerSkeleton {
  std::vector<int> joints;  ///< root to tip, mimic followers and joints shared with other fingers included
  Vector3d p_tip_joint;     ///< fingertip in the frame of the last joint (m)
};

/// Fingers of a length above zero.
struct HandSkeleton {
  KinematicTree tree;  ///< root frame P
  std::vector<FingerSkeleton> fingers;

  int finger_count() const { return static_cast<int>(fingers.size()); }
};

/// Sum of the distances between the joints and to the tip: the finger's length when straight (m).
double finger_length(const KinematicTree& tree, const FingerSkeleton& finger);

double mean_finger_length(const HandSkeleton& hand);

/// Throws Error(invalid_hand) for a finger whose tip lies on its joints.
/// @param tips  one a finger
HandSkeleton make_hand_skeleton(const PalmTree& palm, std::span<const Fingertip> tips);

}  // namespace uhas
