// A palm-arch joint that two fingers share: whose deformation its points follow.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/arch_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;

namespace {

/// Joint values for one displacement of all driving vectors of a finger.
std::vector<double> solve(const HandProfile& profile, int finger, double delta_r) {
  std::vector<double> action(15, 0.0), q(profile.tree.joints.size());
  for (int slot = 0; slot < kSlotCount; ++slot)
    if (profile.fingers[finger].slots[slot]) std::fill_n(action.begin() + kSlotCount + 2 * slot, 2, delta_r);
  CascadeSolver<double> solver(profile, {.passes = 3});
  REQUIRE(solver.solve({.values = action}, q) == Status::ok);
  return q;
}

double from_rest(const HandProfile& profile, const std::vector<double>& q, int joint) {
  return std::abs(q[joint] - profile.joint_traits[joint].q_sphere);
}

/// The arch hand of which only the points of the arch with this sign of canonical azimuth count.
HandProfile with_arch_points_only(HandProfile profile, double sign) {
  for (Correspondence& c : profile.correspondences)
    if (profile.links[c.link].joint != 0 || sign * c.theta < 0) c.weight = 0;
  return profile;
}

}  // namespace

TEST_CASE("a point on a shared link follows the finger nearest in azimuth, whatever the order of the fingers") {
  for (const double mirror : {1.0, -1.0}) {
    HandProfile hand = test::arch_profile();
    if (mirror < 0) {  // the same hand read as a left one: canonical azimuths change their sign
      hand.mirrored = true;
      hand.handedness = Handedness::left;
      for (ProfileFinger& finger : hand.fingers) finger.theta_initial = -finger.theta_initial;
      for (Correspondence& c : hand.correspondences) c.theta = -c.theta;
    }
    for (const int near : {0, 1}) {
      const double side = near == 0 ? mirror : -mirror;
      const HandProfile profile = with_arch_points_only(hand, side);
      CAPTURE(near);
      CHECK(from_rest(profile, solve(profile, near, -0.3), 0) > 0.01);
      CHECK(from_rest(profile, solve(profile, 1 - near, -0.3), 0) < 1e-12);
    }
  }
}

TEST_CASE("of two fingers equally near the first has the point") {
  HandProfile profile = with_arch_points_only(test::arch_profile(), -1);
  profile.fingers[1].theta_initial = profile.fingers[0].theta_initial;
  CHECK(from_rest(profile, solve(profile, 0, -0.3), 0) > 0.01);
  CHECK(from_rest(profile, solve(profile, 1, -0.3), 0) < 1e-12);
}

TEST_CASE("the nearness is measured around the circle") {
  // the points near -0.4 rad are 2.9 rad from a finger at 3.0 and 3.0 rad from one at 2.6 by way of zero
  HandProfile profile = with_arch_points_only(test::arch_profile(), -1);
  profile.fingers[0].theta_initial = 2.6;
  profile.fingers[1].theta_initial = 3.1;
  CHECK(from_rest(profile, solve(profile, 1, -0.3), 0) > 0.01);
  CHECK(from_rest(profile, solve(profile, 0, -0.3), 0) < 1e-12);
}

TEST_CASE("the shared joint is fitted to the points of both fingers, each finger's own joint to its own") {
  const HandProfile profile = test::arch_profile();
  const std::vector<double> q = solve(profile, 0, -0.3);
  CHECK(from_rest(profile, q, 0) > 0.01);
  CHECK(from_rest(profile, q, 1) > 0.01);
  const std::vector<double> closed = solve(profile, 0, -2);
  CHECK(closed[1] == profile.joint_traits[1].q_closed);
  CHECK(closed[0] < profile.joint_traits[0].q_closed);  // the other finger's points still hold it
}
