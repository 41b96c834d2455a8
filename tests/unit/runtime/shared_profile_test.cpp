// One profile serves any number of threads, each with its own copy of a solver, controller, encoder or observer: what
// one thread computes alone, eight compute together. Meant to be run under ThreadSanitizer too (preset `tsan`).
#include <doctest/doctest.h>

#include <cmath>
#include <thread>

#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/encoder.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"
#include "uhas/runtime/joint_groups.hpp"
#include "uhas/runtime/observation.hpp"
#include "uhas/runtime/sphere_controller.hpp"

using namespace uhas;

namespace {

using Results = std::vector<double>;

/// `work(t)` on eight threads at once, t = 0 .. 7; what each returns must be what it returns alone.
template <class Work>
void check_together(const Work& work) {
  constexpr std::size_t kThreads = 8;
  std::vector<Results> results(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) threads.emplace_back([&, t] { results[t] = work(t); });
  }
  const Results alone = work(0);
  CHECK(!alone.empty());
  for (const Results& result : results) CHECK(result == alone);
}

std::vector<std::vector<double>> random_actions(std::size_t count, int vectors) {
  std::mt19937_64 random(11);
  std::vector<std::vector<double>> actions;
  for (std::size_t n = 0; n < count; ++n)
    actions.push_back(test::random_action(random, 0.6, 2.2, vectors > 0 ? vectors : 1 + static_cast<int>(n % 4)));
  return actions;
}

/// Joint values and residuals of all actions, one after another. NaN, which equals nothing, becomes -1.
Results solve_all(CascadeSolver<double> solver, const std::vector<std::vector<double>>& actions) {
  Results results;
  std::vector<double> q(solver.joint_count());
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
  const HandProfile profile = test::small_profile();
  const std::vector<std::vector<double>> actions = random_actions(300, 0);
  for (CascadeRule rule : {CascadeRule::correspondence, CascadeRule::contact}) {
    const SolveOptions options{.rule = rule, .passes = 2};
    const CascadeSolver<double> solver(profile, options);
    check_together([&](std::size_t t) {
      // half of the threads copy the solver, the others compile the shared profile anew
      return solve_all(t % 2 == 0 ? solver : CascadeSolver<double>(profile, options), actions);
    });
  }
}

TEST_CASE("eight threads that share a controller's model lead their hands as one does") {
  const HandProfile profile = test::small_profile();
  const std::vector<std::vector<double>> actions = random_actions(300, 2);
  const SphereController<double> controller(profile, {.time_constant = 0.05});
  check_together([&](std::size_t) {
    SphereController<double> own = controller;
    Results targets = reference_posture(profile), all;
    for (const std::vector<double>& action : actions) {
      const Status status = own.update({.values = action}, 0.01, targets);
      all.insert(all.end(), targets.begin(), targets.end());
      all.push_back(static_cast<double>(status));
    }
    return all;
  });
}

TEST_CASE("eight threads that share an encoder's model encode what one does") {
  const HandProfile profile = test::small_profile();
  const Encoder<double> encoder(profile);
  CascadeSolver<double> solver(profile);
  Results q;
  for (const std::vector<double>& action : random_actions(50, 2)) {
    std::vector<double> solution(solver.joint_count());
    REQUIRE(solver.solve({.values = action}, solution) == Status::ok);
    q.insert(q.end(), solution.begin(), solution.end());
  }
  check_together([&](std::size_t) {
    Encoder<double> own = encoder;
    Results actions(50 * own.action_size());
    return own.encode_batch(q, actions, {}) == Status::ok ? actions : Results{};
  });
}

TEST_CASE("eight threads with a batch solver of several threads each solve what one does") {
  const HandProfile profile = test::small_profile();
  Results values;
  for (const std::vector<double>& action : random_actions(100, 2))
    values.insert(values.end(), action.begin(), action.end());
  check_together([&](std::size_t t) {
    BatchSolver<double> solver(profile, {}, {.threads = 1 + static_cast<int>(t % 3)});
    Results q(100 * solver.joint_count());
    return solver.solve({.count = 100, .values = values}, q) == Status::ok ? q : Results{};
  });
}

TEST_CASE("eight threads that share an observer's model, or one object for fingertips, see what one does") {
  const HandProfile profile = test::small_profile();
  const Observer<double> observer(profile);
  const FingertipKinematics<double> kinematics(profile);
  constexpr std::size_t kHands = 300;
  std::mt19937_64 random(12);
  std::vector<double> q(kHands * observer.joint_count()), qd(q.size());
  for (std::vector<double>* values : {&q, &qd})
    for (double& value : *values) value = std::uniform_real_distribution(-1.0, 1.0)(random);
  check_together([&](std::size_t) {
    Observer<double> own = observer;
    Results observations(kHands * own.size());
    return own.observe_batch(q, qd, observations) == Status::ok ? observations : Results{};
  });
  check_together([&](std::size_t) {
    Results fingertips(kHands * 3 * kinematics.finger_count());
    return kinematics.fingertips_batch(q, fingertips) == Status::ok ? fingertips : Results{};
  });
}
