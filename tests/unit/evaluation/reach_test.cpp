#include "uhas/evaluation/reach.hpp"

#include <doctest/doctest.h>

#include "support/slider_profile.hpp"
#include "uhas/evaluation/battery.hpp"

using namespace uhas;

TEST_CASE("a slide follows as far as its limits") {
  const ReachScore score = measure_reach(test::slider_profile(), {});
  REQUIRE(score.fingers.size() == 2);
  for (const FingerReach& finger : score.fingers) {
    // both driving vectors alike move the point by what is asked, to the limits of 0.5
    CHECK(finger.together.useful_lower == doctest::Approx(-0.5));
    CHECK(finger.together.useful_upper == doctest::Approx(0.5));
    CHECK(finger.together.achieved_lower == doctest::Approx(-0.5));
    CHECK(finger.together.achieved_upper == doctest::Approx(0.5));
    CHECK(finger.together.followed == doctest::Approx(0.25));
    CHECK_FALSE(finger.together.dead);
    // one alone asks for half of it at 90 degrees
    for (const InputReach& radial : finger.radial) {
      CHECK(radial.useful_upper == doctest::Approx(1.0));
      CHECK(radial.achieved_upper == doctest::Approx(1.0));
    }
    // and nothing turns it sideways
    CHECK(finger.azimuth.dead);
    CHECK(finger.azimuth.followed == 0);
  }
}

TEST_CASE("a finger that cannot move has dead inputs") {
  HandProfile profile = test::slider_profile();
  profile.tree.joints[1].lower = -0.01, profile.tree.joints[1].upper = 0.01;
  profile.joint_traits[1].q_open = 0.01, profile.joint_traits[1].q_closed = -0.01;
  const ReachScore score = measure_reach(profile, {});
  CHECK_FALSE(score.fingers[0].together.dead);
  CHECK(score.fingers[1].together.dead);
  CHECK(score.fingers[1].together.followed == 0);
}

TEST_CASE("joints at a limit are counted") {
  const HandProfile profile = test::slider_profile();
  const std::vector<std::vector<double>> battery =
      random_battery(profile, {.actions = 500, .radial_bound = 1, .seed = 3});
  int beyond[2] = {};
  for (const std::vector<double>& action : battery)
    for (int f = 0; f < 2; ++f) {
      const auto [near, far] = test::asked_of(action, f);
      beyond[f] += std::abs(near + far) / 2 > 0.5;
    }
  const ReachScore score = measure_reach(profile, battery);
  REQUIRE(beyond[0] > 0);
  REQUIRE(score.clamped.size() == 2);
  for (int f = 0; f < 2; ++f) {
    CHECK(score.clamped[f].joint == f);
    CHECK(score.clamped[f].share == doctest::Approx(beyond[f] / 500.0));
  }
}
