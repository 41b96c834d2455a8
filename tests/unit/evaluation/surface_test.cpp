#include "uhas/evaluation/surface.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "support/slider_profile.hpp"
#include "uhas/evaluation/battery.hpp"

using namespace uhas;

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

TEST_CASE("a slide keeps its point as far off the sphere as it was, within its limits") {
  const HandProfile profile = test::slider_profile({kPi / 2}, 1.1);
  const std::vector<std::vector<double>> battery =
      random_battery(profile, {.actions = 50, .radial_bound = 0.5, .seed = 1});
  const SurfaceScore score = measure_surface(profile, battery, 2);
  CHECK(score.at_rest.worst == doctest::Approx(0.1));
  CHECK(score.deformed.median == doctest::Approx(0.1));
  CHECK(score.deformed.worst == doctest::Approx(0.1));
  CHECK(score.deformed.count == 100);
}

TEST_CASE("beyond its limits it stays behind by what is missing") {
  const HandProfile profile = test::slider_profile();
  std::vector<double> action(15, 0.8);
  std::fill_n(action.begin(), 5, 0.0);
  const SurfaceScore score = measure_surface(profile, std::vector<std::vector<double>>{action}, 1);
  CHECK(score.deformed.worst == doctest::Approx(0.3));  // at its limit of 0.5
}

TEST_CASE("gaps and coverage") {
  const SurfaceScore score = measure_surface(test::slider_profile({0.5, 0.7, 1.4}), {}, 1);
  for (const FingerSurface& finger : score.fingers) {
    CHECK(finger.phi_least == doctest::Approx(0.5));
    CHECK(finger.phi_greatest == doctest::Approx(1.4));
    CHECK(finger.phi_gap == doctest::Approx(0.7));
  }
  // six rings of equal area: 0.5 rad is in the first, 0.7 in the second, 1.4 in the fifth
  CHECK(score.coverage == doctest::Approx(6.0 / 240));
  // farthest from the plane of both fingers: to the side, near the equator
  CHECK(score.largest_hole == doctest::Approx(kPi / 2).epsilon(0.1));
}
