// float against double, and every instruction set against single solves, over random actions of the full range.
// UHAS_RANDOM_ACTIONS sets their number; the long form is a million.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "support/plain_cascade.hpp"
#include "support/random_action.hpp"
#include "support/real_profile.hpp"
#include "uhas/runtime/batch_solver.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// Random actions whose numbers are floats, so that both types solve the same.
struct Actions {
  std::size_t count;
  std::vector<float> values;
  std::vector<double> wide;
};

const Actions& actions() {
  static const Actions all = [] {
    const char* wish = std::getenv("UHAS_RANDOM_ACTIONS");
    Actions made{.count = wish ? std::strtoull(wish, nullptr, 10) : 20'000, .values = {}, .wide = {}};
    std::mt19937_64 random(23);
    for (std::size_t n = 0; n < made.count; ++n)
      for (double x : random_action(random, 0.5, 2.0)) made.values.push_back(static_cast<float>(x));
    made.wide.assign(made.values.begin(), made.values.end());
    return made;
  }();
  return all;
}

template <class Real>
std::vector<Real> solve_batch(InstructionSet set, std::span<const Real> values) {
  BatchSolver<Real> solver(real_profile(), {}, {.threads = 2, .instruction_set = set});
  std::vector<Real> q(actions().count * solver.joint_count());
  REQUIRE(solver.solve({.count = actions().count, .values = values}, q) == Status::ok);
  return q;
}

template <class Real>
std::vector<Real> solve_singly(std::span<const Real> values) {
  CascadeSolver<Real> solver(real_profile());
  const std::size_t joints = solver.joint_count();
  std::vector<Real> q(actions().count * joints);
  for (std::size_t n = 0; n < actions().count; ++n)
    REQUIRE(solver.solve({.values = values.subspan(15 * n, 15)}, std::span(q).subspan(joints * n, joints)) ==
            Status::ok);
  return q;
}

/// Why a joint's value may be sensitive to rounding, as the solve in double and small changes of the action tell.
std::string cause_at(std::size_t action, std::size_t joint) {
  CascadeSolver<double> solver(real_profile());
  std::vector<double> q(solver.joint_count()), nudged(q.size());
  std::vector<std::uint8_t> at_limit(q.size()), closed(q.size()), nudged_limit(q.size());
  SolveReport report{.residual_rms = 0, .at_limit = at_limit, .closed = closed};
  SolveReport nudged_report{.residual_rms = 0, .at_limit = nudged_limit, .closed = {}};
  std::vector<double> values(actions().wide.begin() + 15 * action, actions().wide.begin() + 15 * (action + 1));
  REQUIRE(solver.solve({.values = values}, q, report) == Status::ok);
  double steepest = 0;
  bool limit_changes = false;
  for (double& value : values) {
    const double kept = value;
    value += 1e-6;
    REQUIRE(solver.solve({.values = values}, nudged, nudged_report) == Status::ok);
    value = kept;
    steepest = std::max(steepest, std::abs(nudged[joint] - q[joint]) / 1e-6);
    limit_changes |= nudged_limit[joint] != at_limit[joint];
  }
  const std::vector<double>& wide = actions().wide;
  const bool fades = std::any_of(wide.begin() + 15 * action + kSlotCount, wide.begin() + 15 * (action + 1),
                                 [](double r) { return r < -0.5; });
  const std::string rate = ", d q / d action up to " + std::to_string(steepest);
  if (limit_changes) return "limit" + rate;
  if (steepest > 1e3) return "branch" + rate;
  return (fades ? "fade" : at_limit[joint] ? "held at a limit" : "none of limit, branch, fade") + rate;
}

}  // namespace

TEST_CASE("float follows double at the 99.9th percentile; the ten worst have a cause") {
  const std::vector<double> q = solve_batch<double>(widest_instruction_set(), actions().wide);
  const std::vector<float> q_float = solve_batch<float>(widest_instruction_set(), actions().values);
  struct Difference {
    double size;
    std::size_t at;
  };
  std::vector<Difference> differences;
  for (std::size_t i = 0; i < q.size(); ++i) differences.push_back({std::abs(q[i] - double(q_float[i])), i});
  const auto larger = [](const Difference& a, const Difference& b) { return a.size > b.size; };
  std::partial_sort(differences.begin(), differences.begin() + 10, differences.end(), larger);
  const std::size_t joints = real_profile().tree.joints.size();
  std::cout << real_profile().hand << ", " << actions().count << " actions of seed 23, float against double:\n";
  for (int k = 0; k < 10; ++k) {
    const std::size_t action = differences[k].at / joints, joint = differences[k].at % joints;
    std::cout << "  " << differences[k].size << " action " << action << ' ' << real_profile().tree.joints[joint].name
              << ": " << cause_at(action, joint) << '\n';
  }
  std::nth_element(differences.begin(), differences.begin() + differences.size() / 1000, differences.end(), larger);
  const double p999 = differences[differences.size() / 1000].size;
  std::cout << "  99.9th percentile " << p999 << '\n';
  CHECK(p999 <= 1e-4);
}

TEST_CASE("the walk of whole fingers solves what the cascade does, joint by joint and point by point") {
  PlainCascade<double> cascade(real_profile());
  CascadeSolver<double> solver(real_profile());
  std::vector<double> q(solver.joint_count());
  std::mt19937_64 random(29);
  double worst = 0;
  for (int n = 0; n < 10'000; ++n) {
    const std::vector<double> values = random_action(random, 0.5, n % 2 == 0 ? 0.5 : 2.0, 1 + n % kMaxDrivingVectors);
    REQUIRE(solver.solve({.values = values}, q) == Status::ok);
    cascade.solve({.values = values});
    for (std::size_t i = 0; i < q.size(); ++i) worst = std::max(worst, std::abs(q[i] - cascade.q[i]));
  }
  std::cout << real_profile().hand << ", the walk and the cascade: " << worst << '\n';
  CHECK(worst < 1e-10);
}

TEST_CASE_TEMPLATE("every instruction set solves what single solves do", Real, float, double) {
  std::span<const Real> values;
  if constexpr (std::is_same_v<Real, float>)
    values = actions().values;
  else
    values = actions().wide;
  const std::vector<Real> expected = solve_singly<Real>(values);
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2}) {
    if (!is_available(set)) continue;
    const std::vector<Real> q = solve_batch<Real>(set, values);
    // an action within rounding of a branch may go either way: a millionth of the values may
    const double tolerance = std::is_same_v<Real, float> ? 1e-4 : 1e-10;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < q.size(); ++i) apart += std::abs(double(q[i]) - double(expected[i])) > tolerance;
    CAPTURE(to_string(set));
    CHECK(apart <= q.size() / 1'000'000);
  }
}
