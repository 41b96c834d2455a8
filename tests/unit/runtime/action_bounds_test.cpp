// The bounds of an action's numbers against what solves make of numbers at and beyond them.
#include <doctest/doctest.h>

#include <cmath>

#include "support/error_check.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/action.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;

namespace {

struct Solved {
  std::vector<double> q;
  bool clamped;
};

Solved solve(CascadeSolver<double>& solver, const std::vector<double>& values, bool normalized = false,
             std::span<const double> offsets = {}) {
  Solved solved{std::vector<double>(solver.joint_count()), false};
  SolveReport report;
  REQUIRE(solver.solve({.values = values, .normalized = normalized, .azimuth_offsets = offsets}, solved.q, report) ==
          Status::ok);
  solved.clamped = report.clamped;
  return solved;
}

}  // namespace

TEST_CASE(
    "a number beyond its bound solves as the bound does, and the report says so; one at the bound is not clamped") {
  const HandProfile profile = test::small_profile();
  for (const ActionConvention& convention : {ActionConvention{}, kUhasSim.convention})
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) {
      CascadeSolver<double> solver(profile, {.convention = convention});
      const ActionBounds bounds = action_bounds(profile, vectors, convention);
      REQUIRE(bounds.lower.size() == std::size_t(kSlotCount * (1 + vectors)));
      std::mt19937_64 random(3);
      for (std::size_t i = 0; i < bounds.lower.size(); ++i)
        for (const auto& [bound, beyond] :
             {std::pair(bounds.lower[i], bounds.lower[i] - 0.3), std::pair(bounds.upper[i], bounds.upper[i] + 0.3)}) {
          std::vector<double> values = test::random_action(random, 0.01, 0.1, vectors);
          values[4] = 0;  // the thumb has no table
          values[i] = bound;
          const Solved at = solve(solver, values);
          values[i] = beyond;
          const Solved past = solve(solver, values);
          CHECK(at.q == past.q);
          CHECK(!at.clamped);
          CHECK(past.clamped);
        }
    }
}

TEST_CASE("normalised numbers are clamped beyond 1, and an offset may bring one beyond its bound") {
  CascadeSolver<double> solver(test::small_profile());
  std::vector<double> values(15, 1.0);
  CHECK(!solve(solver, values, true).clamped);
  values[6] = -1.001;
  CHECK(solve(solver, values, true).clamped);
  const std::vector<double> zeros(15, 0.0), offsets{0, 10, 0, 0, 0};
  CHECK(!solve(solver, zeros).clamped);
  CHECK(solve(solver, zeros, false, offsets).clamped);
}

TEST_CASE("numbers that no finger reads have bounds of 0") {
  HandProfile profile = test::small_profile();
  CHECK(action_bounds(profile).lower[4] == 0);
  CHECK(action_bounds(profile).upper[4] == 0);
  CHECK(action_bounds(profile).upper[0] == profile.lateral_tables[0].delta_theta_upper);
  CHECK(action_bounds(profile).lower[5] == -kRadialBound);
}

TEST_CASE("V and numbers of the convention out of range are refused") {
  test::check_error(ErrorCode::invalid_option, "driving_vectors is 5", [] { action_bounds(test::small_profile(), 5); });
  test::check_error(ErrorCode::invalid_option, "azimuth_sign",
                    [] { action_bounds(test::small_profile(), 2, {.azimuth_sign = 2}); });
}
