#include "uhas/evaluation/battery.hpp"

#include <algorithm>

#include "uhas/evaluation/action_space.hpp"

namespace uhas {

std::vector<std::vector<double>> random_battery(const HandProfile& profile, const BatteryOptions& options) {
  const ActionSpace space(profile);
  std::mt19937_64 random(options.seed);
  std::vector<std::vector<double>> actions;
  for (int n = 0; n < options.actions; ++n) {
    actions.push_back(space.random(random, options.radial_bound));
    if (n % 2 == 0) std::fill_n(actions.back().begin(), kSlotCount, 0.0);
  }
  return actions;
}

}  // namespace uhas
