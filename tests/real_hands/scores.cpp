// What the scores of every hand must be.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <iostream>

#include "support/real_profile.hpp"
#include "uhas/evaluation/battery.hpp"
#include "uhas/evaluation/fit.hpp"
#include "uhas/evaluation/least_squares/optimum.hpp"
#include "uhas/evaluation/smoothness.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("no joint goes further than 12 rad for a radius") {
  const SmoothnessScore score = measure_smoothness(real_profile(), {.lines = 300, .seed = 21, .threads = 2});
  for (const JointStep& step : score.radial) {
    CAPTURE(real_profile().tree.joints[step.joint].name);
    CAPTURE(step.action);
    CAPTURE(step.change);
    CHECK(step.finest_rate <= 12);
    CHECK(step.jump == 0);
  }
}

TEST_CASE("the cascade comes near an optimum that several starts agree on") {
  const std::vector<std::vector<double>> battery = random_battery(real_profile(), {.actions = 200, .seed = 22});
  const std::vector<SolveOptions> solves{{.passes = 1}, {.passes = 3}, {.passes = 10}};
  const FitScore score = measure_fit(real_profile(), battery, solves, 2);
  CHECK(score.unconfirmed <= score.problems / 100);
  const double bounds[] = {1.15, 1.20, 1.05};  // measured: 1.01 to 1.12, 1.00 to 1.07, 1.00 to 1.03
  for (std::size_t s = 0; s < solves.size(); ++s) {
    const Quantiles& ratio = score.solves[s].pooled.ratio;
    std::cout << real_hand().name << ", passes " << solves[s].passes << ": ratio to the optimum " << ratio.median
              << ", p95 " << ratio.p95 << '\n';
    CHECK(ratio.p95 <= bounds[s]);
  }
}

TEST_CASE("to first order one pass is the best fit") {
  const HandProfile& profile = real_profile();
  const std::vector<Joint>& joints = profile.tree.joints;
  // joints that lead, and that are free to: by themselves, turning, moving one finger, off their limits
  const auto leads = [&](int joint) {
    const double q = profile.joint_traits[joint].q_sphere;
    return joints[joint].kind != JointKind::prismatic && q - joints[joint].lower > 0.05 &&
           joints[joint].upper - q > 0.05 &&
           std::ranges::none_of(joints, [&](const Joint& other) { return other.mimic_master == joint; });
  };
  constexpr double small = 1e-3, of_second_order = 3e-5;  // radii, rad
  CascadeSolver<double> solver(profile);
  std::vector<double> q(joints.size()), q_sphere;
  for (const JointTraits& traits : profile.joint_traits) q_sphere.push_back(traits.q_sphere);
  int compared = 0;
  for (const auto& [near, far] : {std::array{small, 0.0}, std::array{0.0, small}, std::array{small, -small}}) {
    std::vector<double> action(15, 0.0);
    for (int slot = 0; slot < kSlotCount; ++slot) action[5 + 2 * slot] = near, action[6 + 2 * slot] = far;
    REQUIRE(solver.solve({.values = action}, q) == Status::ok);
    for (LeastSquares& problem : LeastSquares::of_hand(profile)) {
      if (problem.fingers().size() > 1 || !std::ranges::all_of(problem.unknowns(), leads)) continue;
      problem.set_action(action);
      const Optimum optimum = find_optimum(profile, problem, std::vector<std::vector<double>>{q_sphere, q});
      for (int joint : problem.unknowns()) {
        CAPTURE(joints[joint].name);
        CHECK(std::abs(q[joint] - optimum.q[joint]) <= of_second_order);
        ++compared;
      }
    }
  }
  std::cout << real_hand().name << ": " << compared << " joint values compared\n";
}
