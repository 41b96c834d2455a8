// The actions that a hand is judged by: seeded, and drawn from a stated distribution.
#pragma once

#include <cstdint>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

struct BatteryOptions {
  int actions = 400;
  double radial_bound = 0.6;  ///< of the random displacements, sphere radii
  std::uint64_t seed = 1;
};

/// [actions][15] Displacements uniform within the bound; azimuths zero in every other action, else uniform between the
/// bounds of their fingers' lateral tables.
std::vector<std::vector<double>> random_battery(const HandProfile& profile, const BatteryOptions& options);

}  // namespace uhas
