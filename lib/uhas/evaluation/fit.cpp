#include "uhas/evaluation/fit.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/evaluation/least_squares/optimum.hpp"
#include "uhas/evaluation/parallel.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

constexpr double kNegligible = 0.005;  // radii: a ratio to less says nothing
constexpr double kAgreement = 1e-2;    // of the rms

/// Where the optimiser starts besides the cascade's answer: wrapped, open, closed, at mid-range and half closed; the
/// lateral joints as in `q`.
std::vector<std::vector<double>> starts_of(const HandProfile& profile, const std::vector<int>& unknowns,
                                           const std::vector<double>& q) {
  std::vector<std::vector<double>> starts(6, q);
  for (int i : unknowns) {
    const JointTraits& traits = profile.joint_traits[i];
    const Joint& joint = profile.tree.joints[i];
    starts[1][i] = traits.q_sphere;
    starts[2][i] = traits.q_open;
    starts[3][i] = traits.q_closed;
    starts[4][i] = (joint.lower + joint.upper) / 2;
    starts[5][i] = (traits.q_sphere + traits.q_closed) / 2;
  }
  return starts;
}

/// One action on one problem.
struct Sample {
  bool weighs = false;      // closing has left some point
  double best = 0;          // rms of the optimum
  bool confirmed = true;    // by a second start
  std::vector<double> rms;  // [solve]
};

}  // namespace

FitScore measure_fit(const HandProfile& profile, std::span<const std::vector<double>> actions,
                     std::span<const SolveOptions> solves, int threads) {
  const std::vector<LeastSquares> hand = LeastSquares::of_hand(profile);
  std::vector<CascadeSolver<double>> solvers;
  for (const SolveOptions& solve : solves) solvers.emplace_back(profile, solve);
  solvers.emplace_back(profile, SolveOptions{.passes = 10});  // a start near the optimum

  std::vector<std::vector<Sample>> samples(actions.size(), std::vector<Sample>(hand.size()));
  parallel_for(static_cast<int>(actions.size()), threads, [&] {
    return [&, problems = hand, solvers](int n) mutable {
      std::vector<std::vector<double>> q(solvers.size(), std::vector<double>(profile.tree.joints.size()));
      for (std::size_t s = 0; s < solvers.size(); ++s) solvers[s].solve({.values = actions[n]}, q[s]);
      for (std::size_t k = 0; k < problems.size(); ++k) {
        problems[k].set_action(actions[n]);
        Sample& sample = samples[n][k];
        sample.weighs = problems[k].weight() > 0;
        if (!sample.weighs) continue;
        const Optimum optimum =
            find_optimum(profile, problems[k], starts_of(profile, problems[k].unknowns(), q.back()));
        sample.best = optimum.rms;
        sample.confirmed = optimum.second_rms <= (1 + kAgreement) * optimum.rms;
        for (std::size_t s = 0; s < solves.size(); ++s) sample.rms.push_back(problems[k].rms(q[s]));
      }
    };
  });

  FitScore score;
  std::vector<double> optima;
  for (const std::vector<Sample>& row : samples)
    for (const Sample& sample : row) {
      if (!sample.weighs) continue;
      optima.push_back(sample.best);
      ++score.problems;
      score.negligible += sample.best < kNegligible;
      score.unconfirmed += !sample.confirmed && sample.best >= kNegligible;
    }
  score.optimum = quantiles(optima);
  for (std::size_t s = 0; s < solves.size(); ++s) {
    SolveFit fit{.solve = solves[s], .fingers = std::vector<FingerFit>(profile.fingers.size()), .pooled = {}};
    std::vector<double> all_residuals, all_ratios;
    for (std::size_t k = 0; k < hand.size(); ++k) {
      std::vector<double> residuals, ratios;
      for (const std::vector<Sample>& row : samples) {
        if (!row[k].weighs) continue;
        residuals.push_back(row[k].rms[s]);
        if (row[k].best >= kNegligible) ratios.push_back(std::max(row[k].rms[s] / row[k].best, 1.0));
      }
      all_residuals.insert(all_residuals.end(), residuals.begin(), residuals.end());
      all_ratios.insert(all_ratios.end(), ratios.begin(), ratios.end());
      for (int f : hand[k].fingers()) fit.fingers[f] = {quantiles(residuals), quantiles(ratios)};
    }
    fit.pooled = {quantiles(all_residuals), quantiles(all_ratios)};
    score.solves.push_back(std::move(fit));
  }
  return score;
}

}  // namespace uhas
