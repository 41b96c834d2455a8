// The interpolated field against cases worked by hand.
#include "uhas/runtime/deformation_field.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/small_profile.hpp"

using namespace uhas;
using doctest::Approx;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

/// Five fingers with a plane each, none with a lateral table but the last: only its delta theta counts.
HandProfile hand_with_planes(const std::vector<double>& azimuths) {
  HandProfile profile = test::small_profile();
  const ProfileFinger lateral = profile.fingers[0], plain = profile.fingers[1];
  profile.fingers.clear();
  for (int slot = 0; slot < kSlotCount; ++slot) {
    ProfileFinger finger = slot == 4 ? lateral : plain;
    finger.name = "finger" + std::to_string(slot);
    finger.slots = {};
    finger.slots[slot] = true;
    finger.theta_initial = azimuths[slot];
    profile.fingers.push_back(finger);
  }
  return profile;
}

/// Zeros but for one driving vector of one slot.
std::vector<double> radial_action(int slot, int vector, double delta_r) {
  std::vector<double> action(15, 0.0);
  action[kSlotCount + 2 * slot + vector] = delta_r;
  return action;
}

Spherical<double> moved(const HandProfile& profile, const std::vector<double>& action, double theta, double phi,
                        double radius = 1) {
  DeformationField field(profile);
  Spherical<double> point{theta, phi, radius};
  CHECK(field.deform({.values = action}, {&point, 1}) == Status::ok);
  CHECK(point.polar == phi);
  return point;
}

const HandProfile kSpread = hand_with_planes({80 * kDegree, 40 * kDegree, 0, -40 * kDegree, 180 * kDegree});

}  // namespace

TEST_CASE("a zero action leaves the sphere as it is") {
  for (double theta : {-3.0, -0.5, 0.0, 2.0})
    for (double phi : {0.0, 1.0, kPi}) {
      const Spherical<double> point = moved(kSpread, std::vector<double>(15, 0.0), theta, phi, 0.8);
      CHECK(point.azimuth == theta);
      CHECK(point.radius == 0.8);
    }
}

TEST_CASE(
    "the radius is linear from the pole to the first driving vector, between vectors, and constant beyond the last") {
  const std::vector<double> first = radial_action(2, 0, -0.6), second = radial_action(2, 1, 0.4);
  CHECK(moved(kSpread, first, 0, 0).radius == Approx(1));
  CHECK(moved(kSpread, first, 0, 30 * kDegree).radius == Approx(1 - 0.3));
  CHECK(moved(kSpread, first, 0, 60 * kDegree).radius == Approx(1 - 0.6));
  CHECK(moved(kSpread, first, 0, 90 * kDegree).radius == Approx(1 - 0.3));
  CHECK(moved(kSpread, first, 0, 150 * kDegree).radius == Approx(1));
  CHECK(moved(kSpread, second, 0, 30 * kDegree).radius == Approx(1));
  CHECK(moved(kSpread, second, 0, 75 * kDegree).radius == Approx(1 + 0.1));
  CHECK(moved(kSpread, second, 0, 180 * kDegree).radius == Approx(1 + 0.4));
  CHECK(moved(kSpread, second, 0, 120 * kDegree, 0.7).radius == Approx(0.7 + 0.4));
}

TEST_CASE("between planes the field is linear in azimuth, around the circle") {
  const std::vector<double> middle = radial_action(2, 0, 0.8), thumb = radial_action(4, 0, 0.8);
  const double phi = 60 * kDegree;
  CHECK(moved(kSpread, middle, 10 * kDegree, phi).radius == Approx(1 + 0.8 * 30 / 40));
  CHECK(moved(kSpread, middle, -30 * kDegree, phi).radius == Approx(1 + 0.8 * 10 / 40));
  CHECK(moved(kSpread, middle, 60 * kDegree, phi).radius == Approx(1));
  // the thumb's plane at 180 degrees, its neighbours at 80 and at -40, which is 320
  CHECK(moved(kSpread, thumb, 105 * kDegree, phi).radius == Approx(1 + 0.8 * 25 / 100));
  CHECK(moved(kSpread, thumb, -110 * kDegree, phi).radius == Approx(1 + 0.8 * 70 / 140));
  CHECK(moved(kSpread, thumb, 250 * kDegree, phi).radius == Approx(1 + 0.8 * 70 / 140));
}

TEST_CASE("azimuth turns by the delta theta of the planes, clamped to the finger's table") {
  std::vector<double> action(15, 0.0);
  action[4] = 0.2;
  CHECK(moved(kSpread, action, kPi, 1).azimuth == Approx(kPi + 0.2));
  CHECK(moved(kSpread, action, 105 * kDegree, 1).azimuth == Approx(105 * kDegree + 0.2 / 4));
  CHECK(moved(kSpread, action, 20 * kDegree, 1).azimuth == Approx(20 * kDegree));
  action[4] = 100;
  CHECK(moved(kSpread, action, kPi, 1).azimuth == Approx(kPi + test::small_lateral_table().delta_theta_upper));
}

TEST_CASE("planes closer than five degrees are one, with the mean of their displacements") {
  const HandProfile near = hand_with_planes({178 * kDegree, 60 * kDegree, 0, -60 * kDegree, -178 * kDegree});
  const double phi = 60 * kDegree;
  const std::vector<double> action = radial_action(0, 0, 0.8);
  for (double theta : {178 * kDegree, 180 * kDegree, -178 * kDegree}) {
    const double way = 180 - std::abs(theta) / kDegree;  // of the 120 degrees to the next plane
    CHECK(moved(near, action, theta, phi).radius == Approx(1 + 0.4 * (1 - way / 120)));
  }
  const HandProfile apart = hand_with_planes({177 * kDegree, 60 * kDegree, 0, -60 * kDegree, -177 * kDegree});
  CHECK(moved(apart, action, 177 * kDegree, phi).radius == Approx(1 + 0.8));
  CHECK(moved(apart, action, -177 * kDegree, phi).radius == Approx(1));
}

TEST_CASE("a field may be moved") {
  const std::vector<double> action = radial_action(2, 0, 0.25);
  const Spherical<double> expected = moved(kSpread, action, 0, 60 * kDegree);
  DeformationField made(kSpread), taken(std::move(made)), assigned(test::small_profile());
  assigned = std::move(taken);
  Spherical<double> point{0, 60 * kDegree, 1};
  CHECK(assigned.deform({.values = action}, {&point, 1}) == Status::ok);
  CHECK(point.radius == expected.radius);
  CHECK(point.radius == Approx(1.25));
}

TEST_CASE("an action that the solver would refuse leaves the points as they are") {
  DeformationField field(kSpread);
  Spherical<double> point{0.1, 0.2, 0.3};
  std::vector<double> action(15, 0.5);
  action[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(field.deform({.values = action}, {&point, 1}) == Status::non_finite_input);
  CHECK(field.deform({.values = std::span(action).first(14)}, {&point, 1}) == Status::wrong_size);
  CHECK(point.azimuth == 0.1);
  CHECK(point.radius == 0.3);
}
