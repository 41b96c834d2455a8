// One profile serves any number of threads, each with its own copy of the solver or the observer: what one thread
// computes alone, eight compute together. Meant to be run under ThreadSanitizer too (preset `tsan`).
#include <doctest/doctest.h>

#include <cmath>
#include <thread>

#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/observation.hpp"

using namespace uhas;

namespace {

/// Joint values and residuals of all actions, one after another. NaN, which equals nothing, becomes -1.
std::vector<double> solve_all(CascadeSolver<double> solver, const std::vector<std::vector<double>>& actions) {
  std::vector<double> results, q(solver.joint_count());
  SolveReport report;
  for (const std::vector<double>& action : actions) {
    const Status status = solver.solve({.values = action}, q, report);
    results.push_back(static_cast<double>(status));
    results.insert(results.end(), q.begin(), q.end());
    results.push_back(std::isnan(report.residual_rms) ? -1 : report.residual_rms);
  }
  return results;
}

}  // namespace

TEST_CASE("eight threads that share a profile compute what one does") {
  constexpr std::size_t kThreads = 8, kActions = 300;
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(11);
  std::vector<std::vector<double>> actions;
  for (std::size_t n = 0; n < kActions; ++n)
    actions.push_back(test::random_action(random, 0.6, 2.2, 1 + static_cast<int>(n % 4)));

  for (Rule rule : {Rule::correspondence, Rule::contact}) {
    const CascadeSolver<double> solver(profile, {.rule = rule, .passes = 2});
    const std::vector<double> alone = solve_all(solver, actions);

    std::vector<std::vector<double>> results(kThreads);
    {
      std::vector<std::jthread> threads;
      for (std::size_t t = 0; t < kThreads; ++t)
        threads.emplace_back([&, t] {
          // half of the threads copy the solver, the others compile the shared profile anew
          results[t] =
              solve_all(t % 2 == 0 ? solver : CascadeSolver<double>(profile, {.rule = rule, .passes = 2}), actions);
        });
    }
    for (const std::vector<double>& result : results) CHECK(result == alone);
  }
}

TEST_CASE("eight threads that share an observer's model observe what one does") {
  constexpr std::size_t kThreads = 8, kHands = 300;
  const Observer<double> observer(test::small_profile());
  std::mt19937_64 random(12);
  std::vector<double> q(kHands * observer.joint_count()), qd(q.size());
  for (std::vector<double>* values : {&q, &qd})
    for (double& value : *values) value = std::uniform_real_distribution(-1.0, 1.0)(random);
  const auto observe_all = [&](Observer<double> own) {
    std::vector<double> observations(kHands * own.size());
    return own.observe_batch(q, qd, observations) == Status::ok ? observations : std::vector<double>{};
  };

  std::vector<std::vector<double>> results(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) threads.emplace_back([&, t] { results[t] = observe_all(observer); });
  }
  const std::vector<double> alone = observe_all(observer);
  CHECK(!alone.empty());
  for (const std::vector<double>& result : results) CHECK(result == alone);
}
