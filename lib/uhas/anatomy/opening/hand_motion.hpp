// How the fingers of a hand bend and what they have in common: all that opening the hand goes by.
#pragma once

#include <optional>
#include <vector>

#include "uhas/anatomy/opening/closing_side.hpp"
#include "uhas/anatomy/palm/palm_slab.hpp"

namespace uhas {

/// Where the search for the open pose begins.
struct StartPose {
  std::vector<double> q;   ///< everything at mid range, but for the joints that the config sets
  std::vector<bool> held;  ///< joints of the tree that the config sets: they stay
};

/// Throws Error(invalid_config) for an open value of an unknown joint, of a mimic follower, or outside the limits.
StartPose make_start_pose(const KinematicTree& tree, const HandConfig& config = {});

struct HandMotion {
  std::vector<Flexion> flexions;  ///< one a finger
  bool zero_is_straight = false;  ///< most fingers are straight at zero, so zero is where the designer opened the hand
  std::optional<PalmSlab> slab;   ///< nothing when the palm has no surface, or is no slab
  std::vector<bool> held;         ///< `StartPose::held`
};

HandMotion find_hand_motion(const HandModel& model, const PalmTree& palm, const HandSkeleton& hand,
                            const StartPose& start);

}  // namespace uhas
