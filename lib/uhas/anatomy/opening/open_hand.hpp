// The open hand: where the palm faces and how the hand stands open, each of which follows from the other.
#pragma once

#include <vector>

#include "uhas/anatomy/opening/extension.hpp"

namespace uhas {

struct OpenHand {
  Vector3d palm_normal_palm;            ///< outward, unit, in P
  Vector3d palm_normal_root;            ///< the same in the root link's frame, of which palm_normal_palm is computed
  std::vector<double> q;                ///< the open pose, one value a joint of the tree
  std::vector<FingerPosture> postures;  ///< one a finger, at `q`
  std::vector<HandFinding> findings;    ///< "palm_normal_in_root" and "q_open"
};

/// @param extended    the hand with its fingers extended
/// @param thumb       index of the finger; -1 = none
/// @param R_root_palm rotation of P in the root link's frame
OpenHand open_hand(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                   const Rotationd& R_root_palm, const HandConfig& config = {});

}  // namespace uhas
