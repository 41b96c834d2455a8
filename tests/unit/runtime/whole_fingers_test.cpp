// The walk of fingers that stand alone (docs/method.md#whole-fingers) against the cascade.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "support/arch_profile.hpp"
#include "support/chains_profile.hpp"
#include "support/mirrored_profile.hpp"
#include "support/plain_cascade.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/runtime/cascade/affine_pass.hpp"
#include "uhas/runtime/lanes/lateral_lanes.hpp"

using namespace uhas;

namespace {

/// Random actions, gentle ones and any, solved both ways.
void compare(const HandProfile& profile, const SolveOptions& options, int vectors, double r) {
  CAPTURE(vectors);
  CAPTURE(r);
  CascadeSolver<double> solver(profile, options);
  test::PlainCascade<double> cascade(profile, options);
  std::vector<double> q(solver.joint_count());
  std::vector<std::uint8_t> at_limit(q.size()), closed(q.size());
  std::mt19937_64 random(5);
  for (int n = 0; n < 500; ++n) {
    const std::vector<double> values = test::random_action(random, 0.6, r, vectors);
    SolveReport report{.at_limit = at_limit, .closed = closed};
    REQUIRE(solver.solve({.values = values}, q, report) == Status::ok);
    cascade.solve({.values = values});
    for (std::size_t i = 0; i < q.size(); ++i) CHECK(std::abs(q[i] - cascade.q[i]) < 1e-11);
    CHECK(at_limit == cascade.at_limit);
    CHECK(closed == cascade.closed);
  }
}

}  // namespace

TEST_CASE("a walk gives what the cascade gives, with every number of driving vectors") {
  for (const HandProfile& profile :
       {test::chains_profile(), test::lateral_second_profile(), test::mirror_image(test::chains_profile()),
        test::small_profile(), test::arch_profile()})
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors)
      for (double r : {0.4, 2.0}) compare(profile, {}, vectors, r);
}

TEST_CASE("so it does with other conventions and with hard closing") {
  const HandProfile profile = test::lateral_second_profile();
  compare(profile, {.closing = CascadeClosing::hard}, 2, 2.0);
  compare(profile, {.convention = {.held_toward_pole = true}}, 2, 2.0);
  compare(profile, {.convention = {.absolute_radii = true, .held_toward_pole = true, .azimuth_sign = -1}}, 3, 2.0);
}

TEST_CASE("fingers side by side are those that stand alone, in one pass of the default rule and reading") {
  const auto bundles = [](const HandProfile& profile, const SolveOptions& options, int width) {
    return bundle_fingers(*compile_solver_model<double>(profile, options), width);
  };
  const HandProfile profile = test::lateral_second_profile();
  CHECK(bundles(profile, {}, 1).size() == 2);
  REQUIRE(bundles(profile, {}, 4).size() == 1);
  CHECK(bundles(profile, {}, 4).front().fingers.size() == 2);
  CHECK(bundles(profile, {}, 4).front().before == 1);
  CHECK(bundles(test::chains_profile(), {}, 4).front().before == 0);
  CHECK(bundles(test::arch_profile(), {}, 4).empty());   // both fingers share a joint
  CHECK(bundles(test::small_profile(), {}, 4).empty());  // one has a mimic, the other slides
  CHECK(bundles(profile, {.passes = 2}, 4).empty());
  CHECK(bundles(profile, {.rule = CascadeRule::contact}, 4).empty());
  CHECK(bundles(profile, {.field = FieldReading::field}, 4).empty());
}

TEST_CASE_TEMPLATE("single solves give the same bits with narrow instructions as with wide ones", Real, float, double) {
  const HandProfile profile = test::lateral_second_profile();
  CascadeSolver<Real> wide(profile);
  REQUIRE(setenv("UHAS_INSTRUCTION_SET", "baseline", 1) == 0);
  CascadeSolver<Real> narrow(profile);
  REQUIRE(unsetenv("UHAS_INSTRUCTION_SET") == 0);
  std::vector<Real> q(wide.joint_count()), q_narrow(q.size());
  std::mt19937_64 random(6);
  for (int n = 0; n < 2000; ++n) {
    const std::vector<double> numbers = test::random_action(random, 0.6, n % 2 == 0 ? 0.5 : 2.0);
    const std::vector<Real> values(numbers.begin(), numbers.end());
    SolveReport report, report_narrow;
    REQUIRE(wide.solve({.values = values}, q, report) == Status::ok);
    REQUIRE(narrow.solve({.values = values}, q_narrow, report_narrow) == Status::ok);
    CHECK(q == q_narrow);
    const bool both_dropped = std::isnan(report.residual_rms) && std::isnan(report_narrow.residual_rms);
    CHECK((both_dropped || report.residual_rms == report_narrow.residual_rms));
  }
}

TEST_CASE("the look-up without branches is the other one") {
  const auto check = [](const SolverLateral<double>& table) {
    for (int n = -60; n <= 60; ++n) {
      const double delta_theta = n / 50.0;
      CHECK(look_up_lateral(table, delta_theta) ==
            look_up_lateral<double>(table.inverse_q, table.lower, table.upper, delta_theta));
    }
  };
  check({.lower = -0.5, .upper = 0.7, .inverse_q = {-0.9, -0.3, 0.1, 0.2, 0.8}});
  check({.lower = -0.5, .upper = 0.7, .inverse_q = {0.9, 0.3, 0.1, -0.2, -0.8}});
  check({.lower = 0, .upper = 0.7, .inverse_q = {0.1, 0.1, 0.1, 0.2, 0.8}});
}
