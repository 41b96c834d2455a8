// Seeded random actions.
#pragma once

#include <random>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

/// One action of 5 + 5 V numbers: |d theta| <= `theta`, |d r| <= `r`, uniform.
inline std::vector<double> random_action(std::mt19937_64& random, double theta, double r, int vectors = 2) {
  std::vector<double> action;
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < kSlotCount; ++i) action.push_back(theta * unit(random));
  for (int i = 0; i < kSlotCount * vectors; ++i) action.push_back(r * unit(random));
  return action;
}

}  // namespace uhas::test
