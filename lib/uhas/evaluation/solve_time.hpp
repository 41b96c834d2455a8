// How long a solve takes, here and now: the only score that is not the same every time.
#pragma once

#include <span>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Nanoseconds a solve, default options, double, on the calling thread, by the steady clock.
struct SolveTime {
  double median = 0, p99 = 0;
};

/// Solves every action of `battery` [N][15] twenty times over.
SolveTime measure_solve_time(const HandProfile& profile, std::span<const std::vector<double>> battery);

}  // namespace uhas
