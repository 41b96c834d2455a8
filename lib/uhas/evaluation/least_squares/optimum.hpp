// The best fit there is, by numerical optimisation: what the cascade is measured against.
#pragma once

#include <span>
#include <vector>

#include "uhas/evaluation/least_squares/least_squares.hpp"

namespace uhas {

struct Optimum {
  double rms = 0;         ///< of the best start, sphere radii
  double second_rms = 0;  ///< of the best of all other starts: agrees with `rms` where the optimum can be trusted
  std::vector<double> q;  ///< [joint of the profile] the pose of the best start
};

/// SLSQP (NLopt) from each of `starts` within the joints' limits. The problem has its action.
/// @param starts  poses of all joints of the profile; the other joints stay as in the first
Optimum find_optimum(const HandProfile& profile, LeastSquares& problem, std::span<const std::vector<double>> starts);

}  // namespace uhas
