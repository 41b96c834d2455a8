#include "uhas/evaluation/smoothness.hpp"

#include <doctest/doctest.h>

#include "support/slider_profile.hpp"

using namespace uhas;

TEST_CASE("a slide moves by what is asked: a radius a radius") {
  const SmoothnessScore score = measure_smoothness(test::slider_profile(), {.lines = 20});
  REQUIRE(score.radial.size() == 2);
  CHECK(score.azimuth.empty());
  for (const JointStep& step : score.radial) {
    CHECK(step.rate == doctest::Approx(1.0));
    CHECK(step.finest_rate == doctest::Approx(1.0));
    CHECK(step.jump == 0);
  }
}

TEST_CASE("hard closing is found to jump, and how far") {
  HandProfile profile = test::slider_profile();
  for (int f = 0; f < 2; ++f) {
    profile.tree.joints[f].lower = profile.joint_traits[f].q_closed = -2;
    profile.tree.joints[f].upper = profile.joint_traits[f].q_open = 2;
  }
  const SmoothnessScore score = measure_smoothness(profile, {.lines = 0, .solve = {.closing = CascadeClosing::hard}});
  REQUIRE(score.radial.size() == 2);
  for (int f = 0; f < 2; ++f) {
    // as the sphere vanishes the point has gone to its centre, 1 inward, and the joint closes, 2 inward
    CHECK(score.radial[f].jump == doctest::Approx(1.0).epsilon(1e-4));
    const auto [near, far] = test::asked_of(score.radial[f].action, f);
    CHECK((near + far) / 2 == doctest::Approx(-1.0).epsilon(1e-4));
  }
}

TEST_CASE("the same lines for any number of threads") {
  const HandProfile profile = test::small_profile();
  const SmoothnessScore one = measure_smoothness(profile, {.lines = 30, .threads = 1}),
                        three = measure_smoothness(profile, {.lines = 30, .threads = 3});
  REQUIRE(one.radial.size() == three.radial.size());
  REQUIRE(!one.azimuth.empty());
  for (std::size_t k = 0; k < one.radial.size(); ++k) {
    CHECK(one.radial[k].finest_rate == three.radial[k].finest_rate);
    CHECK(one.radial[k].action == three.radial[k].action);
  }
}
