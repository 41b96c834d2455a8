// All scores of a hand: how well its profile, the sphere and the cascade work for it.
#pragma once

#include <optional>
#include <vector>

#include "uhas/collision/battery_collisions.hpp"
#include "uhas/evaluation/battery.hpp"
#include "uhas/evaluation/fit.hpp"
#include "uhas/evaluation/reach.hpp"
#include "uhas/evaluation/smoothness.hpp"
#include "uhas/evaluation/solve_time.hpp"
#include "uhas/evaluation/surface.hpp"

namespace uhas {

struct EvaluationOptions {
  BatteryOptions battery{};
  int smoothness_lines = 400;
  int threads = 1;
};

/// The hand over the poses of the battery.
struct CollisionScore {
  double share = 0;                 ///< of the actions whose pose is in self-collision
  bool at_rest = false;             ///< the undeformed pose is
  Quantiles distance;               ///< m, least distance of each pose; 0 in contact
  double least_distance = 0;        ///< m, of all
  std::vector<PairContacts> pairs;  ///< worst first
};

struct Evaluation {
  ReachScore reach;
  FitScore fit;  ///< of `evaluated_solves()`
  SurfaceScore surface;
  std::vector<SmoothnessScore> smoothness;  ///< of the solves with the rule `correspondence` in `evaluated_solves()`
  std::optional<CollisionScore> collision;  ///< nothing without geometry
  SolveTime time;
};

/// One, two, three and ten passes of the rule `correspondence`, then the rule `contact`.
std::vector<SolveOptions> evaluated_solves();

/// The same scores, but for the time, for any number of threads.
/// @param geometry  of the hand, or null
/// Throws Error(invalid_option) for numbers out of range.
Evaluation evaluate_hand(const HandProfile& profile, const HandGeometry* geometry, const EvaluationOptions& options);

}  // namespace uhas
