#include "uhas/evaluation/solve_time.hpp"

#include <algorithm>
#include <chrono>

#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

SolveTime measure_solve_time(const HandProfile& profile, std::span<const std::vector<double>> battery) {
  constexpr int rounds = 20;
  using Clock = std::chrono::steady_clock;
  CascadeSolver<double> solver(profile);
  std::vector<double> q(profile.tree.joints.size()), times;
  times.reserve(rounds * battery.size());
  for (int round = 0; round <= rounds; ++round)
    for (const std::vector<double>& action : battery) {
      const Clock::time_point begin = Clock::now();
      solver.solve({.values = action}, q);
      const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
      if (round > 0) times.push_back(taken.count());  // the first round finds cold memory
    }
  if (times.empty()) return {};
  const auto at = [&](std::size_t percent) {
    const auto place = times.begin() + static_cast<std::ptrdiff_t>((times.size() * percent + 99) / 100 - 1);
    std::ranges::nth_element(times, place);
    return *place;
  };
  return {.median = at(50), .p99 = at(99)};
}

}  // namespace uhas
