// How near the cascade comes to the best fit of the hand's points to their targets.
#pragma once

#include <cstdint>
#include <vector>

#include "uhas/evaluation/quantiles.hpp"
#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

struct FitOptions {
  int actions = 400;
  double radial_bound = 0.6;  ///< of the random displacements, sphere radii
  std::uint64_t seed = 1;
  int threads = 1;
  std::vector<SolveOptions> solves;  ///< what is measured; reading `finger` and closing `fade`
};

/// Of one finger, or of all pooled.
struct FingerFit {
  Quantiles residual;  ///< rms distance of points from targets, sphere radii
  Quantiles ratio;     ///< to the optimum's, where that is not negligible (0.005 radii)
};

struct SolveFit {
  SolveOptions solve;
  std::vector<FingerFit> fingers;  ///< [finger of the profile]; one that shares a joint has the figures of all that share it
  FingerFit pooled;
};

struct FitScore {
  std::vector<SolveFit> solves;   ///< as in the options
  Quantiles optimum;              ///< rms of the numerical optimum, pooled, sphere radii
  int problems = 0;               ///< actions times fingers
  int negligible = 0;             ///< of these, with an optimum below 0.005 radii: no ratio
  int unconfirmed = 0;            ///< optima that only one of the starts has found, to 1 % of their rms
};

/// Random actions: azimuths uniform between their bounds (zero in every other action), displacements uniform within the bound.
/// The numerical optimum minimises the same sum over the same limits, from six starts.
FitScore measure_fit(const HandProfile& profile, const FitOptions& options);

}  // namespace uhas
