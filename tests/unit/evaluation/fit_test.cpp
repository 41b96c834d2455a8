#include "uhas/evaluation/fit.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include "support/arch_profile.hpp"
#include "support/slider_profile.hpp"
#include "uhas/evaluation/action_space.hpp"
#include "uhas/evaluation/battery.hpp"
#include "uhas/evaluation/least_squares/least_squares.hpp"

using namespace uhas;

namespace {

constexpr double kPi = std::numbers::pi;

/// Two points of a slide along x, 30 degrees to either side of it, are to move by d0 and d1 along their radii. With x
/// by q the squared distances are (d c - q)^2 + (d s)^2, c = cos 30, s = sin 30: least at q = c (d0 + d1) / 2.
double best_rms(double d0, double d1) {
  const double c = std::cos(kPi / 6), s = std::sin(kPi / 6), q = c * (d0 + d1) / 2;
  return std::sqrt(((d0 * c - q) * (d0 * c - q) + (d1 * c - q) * (d1 * c - q) + (d0 * d0 + d1 * d1) * s * s) / 2);
}

}  // namespace

TEST_CASE("one slide is solved at its optimum, whose residual is known") {
  const HandProfile profile = test::slider_profile({kPi / 3, 2 * kPi / 3});
  const std::vector<std::vector<double>> battery =
      random_battery(profile, {.actions = 200, .radial_bound = 0.4, .seed = 5});
  const std::vector<SolveOptions> solves{{.passes = 1}, {.passes = 3}};
  const FitScore score = measure_fit(profile, battery, solves, 2);

  std::vector<double> residuals[2], all;
  for (const std::vector<double>& action : battery)
    for (int f = 0; f < 2; ++f) {
      const auto [near, far] = test::asked_of(action, f);
      residuals[f].push_back(best_rms(near, far));
      all.push_back(residuals[f].back());
    }
  CHECK(score.problems == 400);
  CHECK(score.unconfirmed == 0);
  CHECK(score.optimum.median == doctest::Approx(quantiles(all).median));
  REQUIRE(score.solves.size() == 2);
  for (const SolveFit& fit : score.solves) {
    for (int f = 0; f < 2; ++f) {
      CHECK(fit.fingers[f].residual.median == doctest::Approx(quantiles(residuals[f]).median));
      CHECK(fit.fingers[f].residual.p95 == doctest::Approx(quantiles(residuals[f]).p95));
      CHECK(fit.fingers[f].residual.worst == doctest::Approx(quantiles(residuals[f]).worst));
    }
    CHECK(fit.pooled.ratio.worst == doctest::Approx(1.0).epsilon(1e-6));
  }
}

TEST_CASE("the contact rule stops where the fingertip meets the sphere, off the optimum by a known ratio") {
  const HandProfile profile = test::slider_profile({kPi / 3, 2 * kPi / 3});
  const std::vector<std::vector<double>> battery =
      random_battery(profile, {.actions = 100, .radial_bound = 0.4, .seed = 6});
  const std::vector<SolveOptions> solves{{.rule = CascadeRule::contact}};
  const FitScore score = measure_fit(profile, battery, solves, 1);
  std::vector<double> ratios;
  for (const std::vector<double>& action : battery)
    for (int f = 0; f < 2; ++f) {
      const auto [near, far] = test::asked_of(action, f);
      const double best = best_rms(near, far), off = (1 - std::cos(kPi / 6)) * (near + far) / 2;
      if (best >= 0.005) ratios.push_back(std::sqrt(best * best + off * off) / best);
    }
  CHECK(score.solves[0].pooled.ratio.count == ratios.size());
  CHECK(score.solves[0].pooled.ratio.median == doctest::Approx(quantiles(ratios).median).epsilon(1e-4));
  CHECK(score.solves[0].pooled.ratio.p95 == doctest::Approx(quantiles(ratios).p95).epsilon(1e-4));
}

TEST_CASE("the score does not depend on the number of threads") {
  const HandProfile profile = test::slider_profile({kPi / 3, 2 * kPi / 3});
  const std::vector<std::vector<double>> battery = random_battery(profile, {.actions = 30});
  const std::vector<SolveOptions> solves{{.passes = 1}};
  const FitScore one = measure_fit(profile, battery, solves, 1), four = measure_fit(profile, battery, solves, 4);
  CHECK(one.solves[0].pooled.residual.worst == four.solves[0].pooled.residual.worst);
  CHECK(one.solves[0].pooled.ratio.median == four.solves[0].pooled.ratio.median);
  CHECK(one.optimum.p95 == four.optimum.p95);
}

TEST_CASE("the least squares are those that the solver reports") {
  for (const HandProfile& profile : {test::small_profile(), test::arch_profile()}) {
    CascadeSolver<double> solver(profile);
    std::vector<LeastSquares> problems = LeastSquares::of_hand(profile);
    const ActionSpace space(profile);
    std::mt19937_64 random(2);
    std::vector<double> q(profile.tree.joints.size());
    for (int n = 0; n < 100; ++n) {
      const std::vector<double> action = space.random(random, n % 2 == 0 ? 0.5 : 1.5);
      SolveReport report;
      REQUIRE(solver.solve({.values = action}, q, report) == Status::ok);
      double sum = 0, weight = 0;
      for (LeastSquares& problem : problems) {
        problem.set_action(action);
        if (!(problem.weight() > 0)) continue;
        const double rms = problem.rms(q);
        sum += problem.weight() * rms * rms;
        weight += problem.weight();
      }
      CAPTURE(profile.hand);
      CAPTURE(n);
      CHECK(std::sqrt(sum / weight) == doctest::Approx(report.residual_rms).epsilon(1e-9));
    }
  }
}

TEST_CASE("the gradient is the difference quotient") {
  for (const HandProfile& profile : {test::small_profile(), test::arch_profile()}) {
    const ActionSpace space(profile);
    std::mt19937_64 random(4);
    for (LeastSquares& problem : LeastSquares::of_hand(profile)) {
      problem.set_action(space.random(random, 0.5));
      std::vector<double> q, x;
      for (const JointTraits& traits : profile.joint_traits) q.push_back(traits.q_sphere);
      for (int joint : problem.unknowns()) x.push_back(q[joint]);
      std::vector<double> gradient(x.size());
      problem.mean_square(q, x, gradient);
      for (std::size_t i = 0; i < x.size(); ++i) {
        constexpr double h = 1e-6;
        std::vector<double> ahead = x, behind = x;
        ahead[i] += h, behind[i] -= h;
        const double quotient = (problem.mean_square(q, ahead, {}) - problem.mean_square(q, behind, {})) / (2 * h);
        CHECK(gradient[i] == doctest::Approx(quotient).epsilon(1e-6));
      }
    }
  }
}
