// How much of its inputs a hand follows.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// One input of a finger, moved over its bounds with all others at zero; the slots of the finger together. `achieved`
/// is in the units of the input: rad that the fingertip turned in azimuth, or radii that the surface points moved
/// outward, as far as they moved in the pattern asked for (its coefficient of least squares, by the solver's weights).
struct InputReach {
  double lower = 0, upper = 0;  ///< bounds of the input
  double useful_lower = 0,
         useful_upper = 0;  ///< from zero outward, as long as every step is followed by a quarter at least
  double achieved_lower = 0, achieved_upper = 0;  ///< at the ends of the useful bounds
  double followed = 0;                            ///< share of the bounds that is useful; 0 when there are none
  bool dead = false;                              ///< the hand moves by less than 5 % of what is asked for
};

struct FingerReach {
  InputReach azimuth;              ///< delta theta
  std::vector<InputReach> radial;  ///< [2] delta r of each driving vector alone
  InputReach together;             ///< both alike: the sphere under the finger grows and shrinks
};

/// How often a joint's fit is held at a limit.
struct ClampedJoint {
  int joint = -1;    ///< index into the profile's joints
  double share = 0;  ///< of the actions, above 0
};

struct ReachScore {
  std::vector<FingerReach> fingers;   ///< [finger of the profile]
  std::vector<ClampedJoint> clamped;  ///< in tree order
};

/// @param battery  [N][15] actions that tell how often joints are held at a limit
/// The solver has its default options.
ReachScore measure_reach(const HandProfile& profile, std::span<const std::vector<double>> battery);

}  // namespace uhas
