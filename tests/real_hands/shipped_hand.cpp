// The hands in hands/ are those whose names they bear: joint for joint, they agree with the models their makers publish
// in geometry, classes, poses and tables. Both are read from their URDFs alone. Names differ, so fingers are matched by
// their slots, joints by their place in the finger.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "support/real_profile.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
// The shipped numbers are the published ones. What is left: right angles that were published with five
// digits (0.004 deg).
constexpr double kAngleTolerance = 0.02 * kDegree;
constexpr double kTipTolerance = 5e-4;  // sphere radii
constexpr double kLimitTolerance = 1e-6;

const HandProfile& shipped_profile() {
  static const HandProfile profile =
      build_profile(UHAS_OWN_HANDS "/" + real_hand().name + "/" + real_hand().name + ".urdf", {});
  return profile;
}

struct Pair {
  const ProfileFinger* real;
  const ProfileFinger* shipped;
};

/// The fingers that own the same slots.
std::vector<Pair> finger_pairs() {
  std::vector<Pair> pairs;
  for (const ProfileFinger& finger : real_profile().fingers) {
    const auto& fingers = shipped_profile().fingers;
    const auto same =
        std::find_if(fingers.begin(), fingers.end(), [&](const ProfileFinger& f) { return f.slots == finger.slots; });
    CAPTURE(finger.name);
    REQUIRE(same != fingers.end());
    REQUIRE(same->joints.size() == finger.joints.size());
    pairs.push_back({&finger, &*same});
  }
  return pairs;
}

/// Fingertip in S, in sphere radii.
Vector3d fingertip(const HandProfile& profile, const ProfileFinger& finger, const std::vector<double>& q) {
  std::vector<RigidTransformd> T(q.size());
  forward_kinematics(profile.tree, q, T);
  const ProfileLink& link = profile.links[finger.tip_link];
  return profile.T_palm_sphere.inverse() * (T[link.joint] * (link.T_joint_link * finger.p_tip_link)) / profile.radius;
}

}  // namespace

TEST_CASE("the same hand: palm, slots, radius") {
  const HandProfile &real = real_profile(), &shipped = shipped_profile();
  CHECK(shipped.fingers.size() == real.fingers.size());
  CHECK(shipped.tree.joints.size() == real.tree.joints.size());
  CHECK(shipped.handedness == real.handedness);
  CHECK(shipped.other_joints.size() == real.other_joints.size());
  std::cout << real.hand << ": radius " << real.radius << " m, shipped " << shipped.radius << " m\n";
  CHECK(std::abs(shipped.radius / real.radius - 1) < 0.1);
}

TEST_CASE("the same joints: limits, classes, poses") {
  const HandProfile &real = real_profile(), &shipped = shipped_profile();
  double difference = 0;
  for (const auto& [a, b] : finger_pairs()) {
    for (std::size_t i = 0; i < a->joints.size(); ++i) {
      const Joint &joint = real.tree.joints[a->joints[i]], &same = shipped.tree.joints[b->joints[i]];
      const JointTraits &traits = real.joint_traits[a->joints[i]], &same_traits = shipped.joint_traits[b->joints[i]];
      CAPTURE(joint.name);
      CAPTURE(same.name);
      CHECK(std::abs(joint.lower - same.lower) < kLimitTolerance);
      CHECK(std::abs(joint.upper - same.upper) < kLimitTolerance);
      CHECK(traits.joint_class == same_traits.joint_class);
      for (const auto pose : {&JointTraits::q_open, &JointTraits::q_sphere, &JointTraits::q_closed}) {
        difference = std::max(difference, std::abs(traits.*pose - same_traits.*pose));
        CHECK(std::abs(traits.*pose - same_traits.*pose) < kAngleTolerance);
      }
    }
  }
  std::cout << real.hand << ": poses differ by " << difference / kDegree << " deg\n";
}

TEST_CASE("the same tables: neutral, azimuth, bounds") {
  const HandProfile &real = real_profile(), &shipped = shipped_profile();
  for (const auto& [a, b] : finger_pairs()) {
    CAPTURE(a->name);
    REQUIRE((a->lateral_table < 0) == (b->lateral_table < 0));
    CHECK(std::abs(wrap_angle(a->theta_initial - b->theta_initial)) < kAngleTolerance);
    CHECK(std::abs(a->tip_phi - b->tip_phi) < kAngleTolerance);
    if (a->lateral_table < 0) continue;
    const LateralTable &table = real.lateral_tables[a->lateral_table], &same = shipped.lateral_tables[b->lateral_table];
    const auto place = [](const ProfileFinger& finger, int joint) {
      return std::find(finger.joints.begin(), finger.joints.end(), joint) - finger.joints.begin();
    };
    CHECK(place(*a, table.joint) == place(*b, same.joint));
    CHECK(std::abs(table.neutral - same.neutral) < kAngleTolerance);
    CHECK(std::abs(table.delta_theta_lower - same.delta_theta_lower) < kAngleTolerance);
    CHECK(std::abs(table.delta_theta_upper - same.delta_theta_upper) < kAngleTolerance);
  }
}

TEST_CASE("the same geometry: fingertips in random poses") {
  const HandProfile &real = real_profile(), &shipped = shipped_profile();
  std::vector<double> q_real(real.tree.joints.size()), q_shipped(shipped.tree.joints.size());
  std::mt19937_64 random(1);
  double difference = 0;
  for (int n = 0; n < 100; ++n) {
    for (const auto& [a, b] : finger_pairs()) {
      for (std::size_t i = 0; i < a->joints.size(); ++i) {
        const Joint& joint = real.tree.joints[a->joints[i]];
        q_real[a->joints[i]] = q_shipped[b->joints[i]] =
            std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
      }
    }
    for (const auto& [a, b] : finger_pairs()) {
      CAPTURE(a->name);
      const double distance = norm(fingertip(real, *a, q_real) - fingertip(shipped, *b, q_shipped));
      difference = std::max(difference, distance);
      CHECK(distance < kTipTolerance);
    }
  }
  std::cout << real.hand << ": fingertips differ by " << difference << " radii\n";
}
