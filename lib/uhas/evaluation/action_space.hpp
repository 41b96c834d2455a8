// The inputs of a hand with two driving vectors a plane, and their bounds.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// [15]: five azimuths, then two displacements a slot.
struct ActionSpace {
  static constexpr int kVectors = 2;
  static constexpr int kInputs = kSlotCount * (1 + kVectors);

  std::vector<double> lower, upper;          ///< [15]
  std::array<int, kSlotCount> first_slot{};  ///< [slot] the first slot of its finger

  explicit ActionSpace(const HandProfile& profile) : lower(kInputs, -kRadialBound), upper(kInputs, kRadialBound) {
    for (int slot = 0; slot < kSlotCount; ++slot) lower[slot] = upper[slot] = 0, first_slot[slot] = slot;
    for (const ProfileFinger& finger : profile.fingers) {
      const int first =
          static_cast<int>(std::find(finger.slots.begin(), finger.slots.end(), true) - finger.slots.begin());
      for (int slot = 0; slot < kSlotCount; ++slot)
        if (finger.slots[slot]) first_slot[slot] = first;
      if (finger.lateral_table < 0) continue;
      const LateralTable& table = profile.lateral_tables[finger.lateral_table];
      for (int slot = 0; slot < kSlotCount; ++slot)
        if (finger.slots[slot]) lower[slot] = table.delta_theta_lower, upper[slot] = table.delta_theta_upper;
    }
  }

  /// Index of the displacement at driving vector `j` of a slot.
  static constexpr int radial(int slot, int j) { return kSlotCount + kVectors * slot + j; }

  /// Gives all slots of a finger the inputs of the first one, so that their mean is what one of them says.
  std::vector<double> with_fingers_agreed(std::vector<double> action) const {
    for (int slot = 0; slot < kSlotCount; ++slot) {
      action[slot] = action[first_slot[slot]];
      for (int j = 0; j < kVectors; ++j) action[radial(slot, j)] = action[radial(first_slot[slot], j)];
    }
    return action;
  }

  std::vector<double> zero() const { return std::vector<double>(kInputs, 0.0); }

  /// Every input uniform between its bounds, displacements in `radial_bound` if that is narrower.
  std::vector<double> random(std::mt19937_64& random, double radial_bound = kRadialBound) const {
    std::vector<double> action;
    for (int i = 0; i < kInputs; ++i) {
      // not std::uniform_real_distribution, whose numbers differ between standard libraries
      const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
      const double low = i < kSlotCount ? lower[i] : -radial_bound, high = i < kSlotCount ? upper[i] : radial_bound;
      action.push_back(low + unit * (high - low));
    }
    return action;
  }
};

}  // namespace uhas
