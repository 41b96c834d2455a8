#include "uhas/evaluation/least_squares/optimum.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

struct Objective {
  LeastSquares& problem;
  std::vector<double> q;
};

double evaluate(unsigned n, const double* x, double* gradient, void* data) {
  Objective& objective = *static_cast<Objective*>(data);
  return objective.problem.mean_square(objective.q, {x, n}, {gradient, gradient == nullptr ? 0 : n});
}

}  // namespace

Optimum find_optimum(const HandProfile& profile, LeastSquares& problem, std::span<const std::vector<double>> starts) {
  const std::vector<int>& unknowns = problem.unknowns();
  std::vector<double> lower, upper;
  for (int joint : unknowns) {
    lower.push_back(profile.tree.joints[joint].lower);
    upper.push_back(profile.tree.joints[joint].upper);
  }
  Objective objective{problem, starts.front()};
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
      nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(unknowns.size())), nlopt_destroy);
  nlopt_set_lower_bounds(optimizer.get(), lower.data());
  nlopt_set_upper_bounds(optimizer.get(), upper.data());
  nlopt_set_min_objective(optimizer.get(), evaluate, &objective);
  nlopt_set_xtol_rel(optimizer.get(), 1e-8);
  nlopt_set_maxeval(optimizer.get(), 200);

  constexpr double none = std::numeric_limits<double>::infinity();
  Optimum best{.rms = none, .second_rms = none, .q = starts.front()};
  for (const std::vector<double>& start : starts) {
    std::vector<double> x;
    for (std::size_t i = 0; i < unknowns.size(); ++i) x.push_back(std::clamp(start[unknowns[i]], lower[i], upper[i]));
    double value = 0;  // whatever stopped it, rounding too, `x` is the best it has seen
    nlopt_optimize(optimizer.get(), x.data(), &value);
    const double rms = std::sqrt(problem.mean_square(objective.q, x, {}));
    best.second_rms = std::min(best.second_rms, std::max(rms, best.rms));
    if (rms < best.rms) best.rms = rms, best.q = objective.q;
  }
  return best;
}

}  // namespace uhas
