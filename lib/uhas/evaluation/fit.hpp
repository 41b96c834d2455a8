// How near the cascade comes to the best fit of the hand's points to their targets.
#pragma once

#include <span>
#include <vector>

#include "uhas/evaluation/quantiles.hpp"
#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// Of one finger, or of all pooled.
struct FingerFit {
  Quantiles residual;  ///< rms distance of points from targets, sphere radii
  Quantiles ratio;     ///< to the optimum's, where that is not negligible (0.005 radii)
};

struct SolveFit {
  SolveOptions solve;
  std::vector<FingerFit>
      fingers;  ///< [finger of the profile]; one that shares a joint has the figures of all that share it
  FingerFit pooled;
};

struct FitScore {
  std::vector<SolveFit> solves;  ///< in the order asked for
  Quantiles optimum;             ///< rms of the numerical optimum, pooled, sphere radii
  int problems = 0;              ///< actions times fingers
  int negligible = 0;            ///< of these, with an optimum below 0.005 radii: no ratio
  int unconfirmed = 0;           ///< optima that only one of the starts has found, to 1 % of their rms
};

/// The numerical optimum minimises the same sum over the same limits, from six starts.
/// @param actions  [N][15]
/// @param solves   what is measured; reading `finger` and closing `fade`
/// @param threads  at least 1; the score does not depend on it
FitScore measure_fit(const HandProfile& profile, std::span<const std::vector<double>> actions,
                     std::span<const SolveOptions> solves, int threads);

}  // namespace uhas
