// The recipe of today's retargeting libraries: sequential quadratic programming (NLopt's SLSQP) over all joints of the
// hand at once, as dex-retargeting's position optimiser does it.
#pragma once

#include <memory>
#include <span>

#include "hand_case.hpp"

namespace uhas::benchmark {

struct SlsqpRecipe {
  double stay_weight;  ///< of the squared distance from the last answer, per rad^2
  double stop_gain;    ///< stop when a step gains less
};
/// That library's numbers. They stop where the fingertips are still millimetres away.
inline constexpr SlsqpRecipe kSlsqpAsShipped{.stay_weight = 4e-3, .stop_gain = 1e-5};
/// The same recipe, run until the fingertips are as near as the other peers bring them.
inline constexpr SlsqpRecipe kSlsqpToTarget{.stay_weight = 0, .stop_gain = 1e-10};

class SlsqpPeer {
 public:
  SlsqpPeer(const HandProfile& profile, const SlsqpRecipe& recipe);
  ~SlsqpPeer();

  /// Minimises the mean Huber loss (delta 0.02 m, as that library has it) of the fingertips' coordinates, and the
  /// squared distance from the last answer, within limits.
  /// @param targets  [fingers][3] m, palm frame
  /// @param q        [joints] in the profile's order: the last answer in, the answer out. Followers are neither read
  /// nor
  ///                 written.
  void reach(std::span<const double> targets, std::span<double> q);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace uhas::benchmark
