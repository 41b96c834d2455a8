#include "uhas/collision/action_way.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;

namespace {

std::vector<double> solve(const HandProfile& profile, const SolveOptions& options, const Action<double>& action) {
  CascadeSolver<double> solver(profile, options);
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve(action, q) == Status::ok);
  return q;
}

void check_equal(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(std::abs(a[i] - b[i]) < 1e-9);
}

}  // namespace

TEST_CASE("the way leads from the undeformed hand to the action, in every convention") {
  const HandProfile profile = test::small_profile();
  const std::vector<double> undeformed = solve(profile, {}, {.values = std::vector<double>(15, 0.0)});
  std::mt19937_64 random(1);
  for (const SolveOptions& options : {kUhas, kUhasSim}) {
    ActionWay way(profile, options.convention);
    const std::vector<double> at_rest =
        options.rule == CascadeRule::contact
            ? solve(profile, {.rule = CascadeRule::contact}, {.values = std::vector<double>(15, 0.0)})
            : undeformed;
    for (const bool normalized : {false, true}) {
      for (const double size : {0.5, 5.0}) {  // within and beyond the bounds
        CAPTURE(options.convention.absolute_radii);
        CAPTURE(normalized);
        CAPTURE(size);
        const std::vector<double> values = test::random_action(random, size, size);
        const Action<double> action{.values = values, .normalized = normalized};
        way.lead_to(action);
        check_equal(solve(profile, options, way.at(0)), at_rest);
        check_equal(solve(profile, options, way.at(1)), solve(profile, options, action));
      }
    }
  }
}

TEST_CASE("between its ends the deformation is scaled") {
  const HandProfile profile = test::small_profile();
  ActionWay way(profile, {});
  const std::vector<double> values{0.04, 0, 0, 0, 0, 1, -1, 2, -2, 0.5, 0, 0, 0, 0, 1};
  way.lead_to({.values = values});
  const Action<double> half = way.at(0.5);
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(half.values[i] == 0.5 * values[i]);

  ActionWay radii(profile, kUhasSim.convention);
  const std::vector<double> action(15, 0.0);
  radii.lead_to({.values = action});
  CHECK(radii.at(0.75).values[5] == 0.25);  // from a radius of 1 to 0
}

TEST_CASE("what lies beyond the bounds does not shorten the way") {
  const HandProfile profile = test::small_profile();
  ActionWay way(profile, {});
  std::vector<double> values(15, 1000.0);
  values[0] = -1000;
  way.lead_to({.values = values});
  const LateralTable& table = profile.lateral_tables[0];
  CHECK(way.at(0.5).values[0] == 0.5 * table.delta_theta_lower);
  CHECK(way.at(0.5).values[1] == 0.5 * table.delta_theta_upper);
  CHECK(way.at(0.5).values[4] == 0);  // the thumb has no table
  CHECK(way.at(0.5).values[5] == 1);

  const std::vector<double> bounds{-0.25, 0.5};
  way.lead_to({.values = values, .radial_bounds = bounds});
  CHECK(way.at(0.5).values[5] == 0.25);
}
