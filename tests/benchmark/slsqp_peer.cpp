#include "slsqp_peer.hpp"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "peer_jacobian.hpp"

namespace uhas::benchmark {
namespace {

constexpr double kHuberDelta = 0.02;  // m

}  // namespace

struct SlsqpPeer::State {
  SlsqpRecipe recipe;
  std::vector<PeerFinger> fingers;
  std::vector<int> unknowns;                // profile's index of each
  std::vector<std::vector<int>> of_finger;  // [finger][its unknown] index into `unknowns`
  nlopt::opt optimiser;
  std::vector<double> lower, upper, targets, last, x;

  State(const HandProfile& profile, const SlsqpRecipe& chosen) : recipe(chosen) {
    for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
      const PeerFinger& finger = fingers.emplace_back(profile, int(f));
      std::vector<int>& mine = of_finger.emplace_back();
      for (std::size_t u = 0; u < finger.unknowns.size(); ++u) {
        auto found = std::ranges::find(unknowns, finger.unknowns[u]);
        if (found == unknowns.end()) {
          found = unknowns.insert(unknowns.end(), finger.unknowns[u]);
          lower.push_back(finger.lower[u]), upper.push_back(finger.upper[u]);
        }
        mine.push_back(int(found - unknowns.begin()));
      }
    }
    x.resize(unknowns.size());
    optimiser = nlopt::opt(nlopt::LD_SLSQP, unsigned(unknowns.size()));
    optimiser.set_lower_bounds(lower);
    optimiser.set_upper_bounds(upper);
    optimiser.set_ftol_abs(recipe.stop_gain);
    optimiser.set_min_objective(
        [](unsigned, const double* values, double* gradient, void* state) {
          return static_cast<const State*>(state)->objective(values, gradient);
        },
        this);
  }

  double objective(const double* values, double* gradient) const {
    const double coordinates = double(targets.size());
    double sum = 0;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const double moved = values[i] - last[i];
      sum += recipe.stay_weight * moved * moved;
      if (gradient) gradient[i] = 2 * recipe.stay_weight * moved;
    }
    Jacobian J;
    for (std::size_t f = 0; f < fingers.size(); ++f) {
      const std::vector<int>& mine = of_finger[f];
      const Vector3d p = fingertip_with_jacobian(
          fingers[f], [&](int u) { return values[mine[u]]; }, J);
      const Vector3d error = p - Vector3d{targets[3 * f], targets[3 * f + 1], targets[3 * f + 2]};
      Vector3d slope;
      const auto add = [&](double e, double& slope_of) {
        const double size = std::abs(e);
        sum += (size < kHuberDelta ? 0.5 * e * e / kHuberDelta : size - 0.5 * kHuberDelta) / coordinates;
        slope_of = (size < kHuberDelta ? e / kHuberDelta : std::copysign(1.0, e)) / coordinates;
      };
      add(error.x, slope.x), add(error.y, slope.y), add(error.z, slope.z);
      if (!gradient) continue;
      for (std::size_t u = 0; u < mine.size(); ++u) gradient[mine[u]] += dot(slope, J[u]);
    }
    return sum;
  }
};

SlsqpPeer::SlsqpPeer(const HandProfile& profile, const SlsqpRecipe& recipe)
    : state_(std::make_unique<State>(profile, recipe)) {}
SlsqpPeer::~SlsqpPeer() = default;

void SlsqpPeer::reach(std::span<const double> targets, std::span<double> q) {
  State& state = *state_;
  state.targets.assign(targets.begin(), targets.end());
  for (std::size_t i = 0; i < state.x.size(); ++i)
    state.x[i] = std::clamp(q[state.unknowns[i]], state.lower[i], state.upper[i]);
  state.last = state.x;
  double least = 0;
  try {
    state.optimiser.optimize(state.x, least);
  } catch (const nlopt::roundoff_limited&) {  // x is the best point found
  }
  for (std::size_t i = 0; i < state.x.size(); ++i) q[state.unknowns[i]] = state.x[i];
}

}  // namespace uhas::benchmark
