#include "uhas/anatomy/opening/palm_normal.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "postures.hpp"
#include "uhas/anatomy/opening/normal_error.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// Fingers around +z, each at `azimuth`, that stand `outward` of the axis and close accordingly.
FingerPosture around_z(double azimuth, double outward) {
  const Vector3d radial{std::cos(azimuth), std::sin(azimuth), 0}, z{0, 0, 1};
  return make_posture(0.03 * radial, std::sin(outward) * radial + std::cos(outward) * z,
                      std::sin(outward) * z - std::cos(outward) * radial);
}

}  // namespace

TEST_CASE("the normal of a row is the mean closing direction, without the thumb's") {
  std::vector<FingerPosture> postures;
  for (const double tilt : {-0.2, 0.0, 0.2})
    postures.push_back(
        make_posture({0, tilt, 0}, {-std::sin(tilt), 0, std::cos(tilt)}, {std::cos(tilt), 0, std::sin(tilt)}));
  postures.push_back(make_posture({}, {0, 0, 1}, {0, 1, 0}));
  const PalmNormal found = find_palm_normal(postures, 3);
  CHECK_FALSE(found.opposing);
  CHECK(norm(found.normal - Vector3d{1, 0, 0}) < 1e-12);
  CHECK(norm(found.axis - Vector3d{0, 1, 0}) < 1e-12);
  CHECK(found.spread == doctest::Approx(std::sqrt(2 * 0.2 * 0.2 / (3 * 2))));
  CHECK(found.coherence > 0.9);
}

TEST_CASE("fingers that are open around an axis close along it") {
  std::vector<FingerPosture> postures;
  for (int i = 0; i < 3; ++i) postures.push_back(around_z(2 * std::numbers::pi * i / 3, std::numbers::pi / 2));
  const PalmNormal found = find_palm_normal(postures, -1);
  CHECK(norm(found.normal - Vector3d{0, 0, 1}) < 1e-12);
  CHECK(found.coherence == doctest::Approx(1));
}

TEST_CASE("fingers that close against each other face along their axis, however far they are open") {
  for (const double outward : {-0.5, 0.0, 0.5}) {
    std::vector<FingerPosture> postures;
    for (int i = 0; i < 3; ++i) postures.push_back(around_z(2 * std::numbers::pi * i / 3, outward));
    const PalmNormal found = find_palm_normal(postures, -1);
    CHECK(found.opposing);
    CHECK(norm(found.normal - Vector3d{0, 0, 1}) < 1e-12);
    CHECK(found.coherence == doctest::Approx(std::min(1.0, std::sin(outward) + std::cos(outward))));
  }
}

TEST_CASE("a thumb that closes against two fingers makes a gripper, against three a hand") {
  for (const int fingers : {2, 3}) {
    std::vector<FingerPosture> postures;
    for (int i = 0; i < fingers; ++i) postures.push_back(make_posture({0, 0.02 * i, 0}, {0, 0, 1}, {1, 0, 0}));
    postures.push_back(make_posture({0.05, 0, 0}, {0, 0, 1}, {-1, 0, 0}));
    const PalmNormal found = find_palm_normal(postures, fingers);
    CHECK(found.opposing == (fingers == 2));
    CHECK(norm(found.normal - (fingers == 2 ? Vector3d{0, 0, 1} : Vector3d{1, 0, 0})) < 1e-12);
  }
}

TEST_CASE("the normal's error: half of the fingers' own is common to all, a row's spread adds, a slab may contradict") {
  HandSkeleton hand;
  HandMotion motion;
  motion.zero_is_straight = true;
  ExtendedHand extended;
  for (int i = 0; i < 4; ++i) {
    hand.tree.joints.emplace_back();
    hand.fingers.push_back({{i}, {0, 0, 0.1}});
    motion.flexions.push_back({{{0}, false}, {1, 1}});
    extended.bases.push_back({0.2, true});
    extended.q.push_back(0);
  }
  extended.postures = make_postures_of_hand(3);
  PalmNormal normal = find_palm_normal(extended.postures, 3);
  const auto error = [&] { return palm_normal_error(hand, motion, extended, 3, normal); };
  const double of_bases = 0.2 * std::sqrt((9.0 + 3) / (2 * 9));  // ((3 e)^2 + 3 e^2) / (2 * 3^2)
  CHECK(error() == doctest::Approx(of_bases));
  normal.spread = 0.1;
  CHECK(error() == doctest::Approx(std::hypot(of_bases, 0.1)));
  normal.spread = 0;
  motion.slab = PalmSlab{{std::cos(0.3), 0, std::sin(0.3)}, 0.1};
  CHECK(error() == doctest::Approx(std::sqrt(of_bases * of_bases + 0.3 * 0.3 - 0.1 * 0.1)));
  normal.opposing = true;
  CHECK(error() == doctest::Approx(0.2 / 2));  // of four fingers: the thumb counts
}
