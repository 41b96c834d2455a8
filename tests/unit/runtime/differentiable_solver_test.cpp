// Jacobians against differences of solves.
#include "uhas/runtime/differentiable_solver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/arch_profile.hpp"
#include "support/chains_profile.hpp"
#include "support/error_check.hpp"
#include "support/mirrored_profile.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"

using namespace uhas;

namespace {

/// How an action is read besides its numbers.
struct Reading {
  bool normalized = false;
  std::vector<double> phi{}, offsets{}, bounds{};

  Action<double> action(const std::vector<double>& values) const {
    return {.values = values,
            .driving_vectors_phi = phi,
            .normalized = normalized,
            .azimuth_offsets = offsets,
            .radial_bounds = bounds};
  }
};

/// Central differences with half the step must agree with those of the step, or a kink lies between: such numbers are
/// not compared. Returns the share that was.
double compare(const HandProfile& profile, const SolveOptions& options, const Reading& reading, int vectors, double r) {
  CAPTURE(vectors);
  CAPTURE(r);
  DifferentiableSolver<double> solver(profile, options);
  CascadeSolver<double> plain(profile, options);
  const std::size_t joints = solver.joint_count(), numbers = kSlotCount * (1 + vectors);
  std::vector<double> q(joints), jacobian(joints * numbers), expected(joints), ahead(joints), behind(joints);
  std::mt19937_64 random(11);
  std::size_t compared = 0, all = 0;
  for (int n = 0; n < 60; ++n) {
    std::vector<double> values = test::random_action(random, 0.4, r, vectors);
    REQUIRE(solver.solve_with_jacobian(reading.action(values), q, jacobian) == Status::ok);
    REQUIRE(plain.solve(reading.action(values), expected) == Status::ok);
    CHECK(q == expected);
    for (std::size_t i = 0; i < numbers; ++i) {
      const auto difference = [&](double step) {
        const double kept = values[i];
        values[i] = kept + step;
        REQUIRE(plain.solve(reading.action(values), ahead) == Status::ok);
        values[i] = kept - step;
        REQUIRE(plain.solve(reading.action(values), behind) == Status::ok);
        values[i] = kept;
        std::vector<double> slopes;
        for (std::size_t j = 0; j < joints; ++j) slopes.push_back((ahead[j] - behind[j]) / (2 * step));
        return slopes;
      };
      const std::vector<double> coarse = difference(2e-5), fine = difference(1e-5);
      for (std::size_t j = 0; j < joints; ++j) {
        ++all;
        if (std::abs(coarse[j] - fine[j]) > 1e-7 * (1 + std::abs(fine[j]))) continue;
        ++compared;
        CHECK(std::abs(jacobian[j * numbers + i] - fine[j]) <= 1e-5 * (1 + std::abs(fine[j])));
      }
    }
  }
  return double(compared) / double(all);
}

}  // namespace

TEST_CASE("derivatives are those that differences of solves approach") {
  for (const HandProfile& profile : {test::chains_profile(), test::mirror_image(test::chains_profile()),
                                     test::small_profile(), test::arch_profile()})
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors)
      for (double r : {0.4, 1.5}) CHECK(compare(profile, {}, {}, vectors, r) > 0.9);
}

TEST_CASE("so they are with several passes, hard closing and every option of an action") {
  for (const HandProfile& profile : {test::chains_profile(), test::small_profile(), test::arch_profile()}) {
    CHECK(compare(profile, {.passes = 3}, {}, 2, 0.4) > 0.9);
    CHECK(compare(profile, {.closing = CascadeClosing::hard}, {}, 2, 1.5) > 0.9);
    CHECK(compare(profile, {.convention = kUhasSim.convention}, {}, 2, 0.4) > 0.9);
    CHECK(compare(profile, {}, {.normalized = true, .bounds = {-0.4, 0.8}}, 3, 0.9) > 0.9);
    CHECK(compare(profile, {}, {.offsets = {0.1, -0.1, 0.2, 0, 0.3}, .bounds = {-0.3, 0.3}}, 2, 0.5) > 0.9);
    CHECK(compare(profile, {}, {.phi = {0.8, 1.9}}, 2, 0.4) > 0.9);
  }
}

TEST_CASE("a joint at a limit and a number beyond its bound have derivatives of 0") {
  DifferentiableSolver<double> solver(test::chains_profile());
  CascadeSolver<double> plain(test::chains_profile());
  std::vector<double> q(5), jacobian(5 * 15);
  std::vector<std::uint8_t> at_limit(5);
  SolveReport report{.at_limit = at_limit, .closed = {}};
  std::mt19937_64 random(2);
  int held = 0;
  for (int n = 0; n < 200; ++n) {
    std::vector<double> values = test::random_action(random, 0.4, 0.5);
    values[0] = 3;
    REQUIRE(solver.solve_with_jacobian({.values = values}, q, jacobian) == Status::ok);
    REQUIRE(plain.solve({.values = values}, q, report) == Status::ok);
    for (std::size_t j = 0; j < 5; ++j) {
      CHECK(jacobian[j * 15] == 0);
      if (!at_limit[j]) continue;
      ++held;
      for (std::size_t i = 0; i < 15; ++i) CHECK(jacobian[j * 15 + i] == 0);
    }
  }
  CHECK(held > 0);
}

TEST_CASE("float derivatives follow double ones") {
  DifferentiableSolver<float> solver(test::chains_profile());
  DifferentiableSolver<double> wide(test::chains_profile());
  std::vector<float> q(5), jacobian(75);
  std::vector<double> q_wide(5), jacobian_wide(75);
  std::mt19937_64 random(4);
  for (int n = 0; n < 100; ++n) {
    const std::vector<double> numbers = test::random_action(random, 0.3, 0.3);
    const std::vector<float> values(numbers.begin(), numbers.end());
    const std::vector<double> same(values.begin(), values.end());
    REQUIRE(solver.solve_with_jacobian({.values = values}, q, jacobian) == Status::ok);
    REQUIRE(wide.solve_with_jacobian({.values = same}, q_wide, jacobian_wide) == Status::ok);
    double worst = 0;
    for (std::size_t i = 0; i < jacobian.size(); ++i) worst = std::max(worst, std::abs(jacobian[i] - jacobian_wide[i]));
    CHECK(worst < 1e-3);
  }
}

TEST_CASE("what cannot be differentiated is refused, and so are wrong sizes") {
  test::check_error(ErrorCode::invalid_option, "contact",
                    [] { DifferentiableSolver<double>(test::chains_profile(), {.rule = CascadeRule::contact}); });
  test::check_error(ErrorCode::invalid_option, "field",
                    [] { DifferentiableSolver<double>(test::chains_profile(), {.field = FieldReading::field}); });
  DifferentiableSolver<double> solver(test::chains_profile());
  std::vector<double> values(15), q(5, 7.0), jacobian(75, 7.0);
  CHECK(solver.solve_with_jacobian({.values = values}, q, std::span(jacobian).first(74)) == Status::wrong_size);
  values[3] = NAN;
  CHECK(solver.solve_with_jacobian({.values = values}, q, jacobian) == Status::non_finite_input);
  CHECK(q == std::vector<double>(5, 7.0));
  CHECK(jacobian == std::vector<double>(75, 7.0));
  DifferentiableSolver<double> copy = solver;
  values[3] = 0;
  CHECK(copy.solve_with_jacobian({.values = values}, q, jacobian) == Status::ok);
}
