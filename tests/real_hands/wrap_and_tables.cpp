// What must hold of joint classes, wrap and lateral tables on every hand (docs/method.md#joint-classes,
// docs/method.md#wrap, docs/method.md#lateral-tables).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "support/real_profile.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Vector3d fingertip_in_S(const HandProfile& profile, const ProfileFinger& finger, std::vector<double> q) {
  apply_mimics(profile.tree, q);
  std::vector<RigidTransformd> T(q.size());
  forward_kinematics(profile.tree, q, T);
  const ProfileLink& link = profile.links[finger.tip_link];
  return profile.T_palm_sphere.inverse() * (T[link.joint] * (link.T_joint_link * finger.p_tip_link));
}

std::vector<double> q_sphere(const HandProfile& profile) {
  std::vector<double> q;
  for (const JointTraits& traits : profile.joint_traits) q.push_back(traits.q_sphere);
  return q;
}

}  // namespace

TEST_CASE("classes agree with truth.json on every joint that is not ambiguous") {
  const HandProfile& profile = real_profile();
  int right = 0;
  for (const auto& finger : real_hand().truth.at("fingers")) {
    for (const auto& [name, expected] : finger.at("classes").items()) {
      if (expected == "ambiguous" || finger.at("mimic").contains(name)) continue;
      const auto joint = std::find_if(profile.tree.joints.begin(), profile.tree.joints.end(),
                                      [&](const Joint& j) { return j.name == name; });
      CAPTURE(name);
      REQUIRE(joint != profile.tree.joints.end());
      const JointTraits& traits = profile.joint_traits[joint - profile.tree.joints.begin()];
      CAPTURE(traits.lateral_motion);
      CAPTURE(traits.encompassing_motion);
      CHECK((traits.joint_class == JointClass::lateral ? "lateral" : "encompassing") == expected.get<std::string>());
      ++right;
    }
  }
  std::cout << profile.hand << ": " << right << " joints compared\n";
}

TEST_CASE("the fingertips of the wrapped hand stand near the equator") {
  const HandProfile& profile = real_profile();
  const int thumb = real_hand().truth.at("n_fingers") > 3 ? thumb_of(profile) : -1;
  for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
    const ProfileFinger& finger = profile.fingers[f];
    const Spherical<double> tip = to_spherical(fingertip_in_S(profile, finger, q_sphere(profile)));
    CAPTURE(finger.name);
    std::cout << profile.hand << ' ' << finger.name << ": phi " << tip.polar / kDegree << " deg, radius "
              << tip.radius / profile.radius << '\n';
    CHECK(tip.polar == doctest::Approx(finger.tip_phi).epsilon(1e-9));
    if (static_cast<int>(f) == thumb) continue;  // reported only
    CHECK(tip.polar >= 70 * kDegree);
    CHECK(tip.polar <= 110 * kDegree);
  }
}

TEST_CASE("lateral tables: round trip, neutral bit for bit, monotone") {
  const HandProfile& profile = real_profile();
  for (const ProfileFinger& finger : profile.fingers) {
    if (finger.lateral_table < 0) {
      std::cout << profile.hand << ' ' << finger.name << ": no lateral joint\n";
      continue;
    }
    const LateralTable& table = profile.lateral_tables[finger.lateral_table];
    CAPTURE(finger.name);
    const auto look_up = [&](double delta) {
      return look_up_lateral<double>(table.inverse_q, table.delta_theta_lower, table.delta_theta_upper, delta);
    };
    CHECK(look_up(0) == profile.joint_traits[table.joint].q_sphere);
    CHECK(look_up(0) == table.neutral);
    std::cout << profile.hand << ' ' << finger.name << ": " << profile.tree.joints[table.joint].name << " neutral "
              << table.neutral << ", theta " << table.theta_initial / kDegree << " deg, delta theta "
              << table.delta_theta_lower / kDegree << " to " << table.delta_theta_upper / kDegree << " deg, "
              << table.inverse_q.size() << " knots\n";
    for (std::size_t i = 0; i + 1 < table.q.size(); ++i) {
      for (double share : {0.0, 0.3, 0.5, 1.0}) {
        const double q = table.q[i] + share * (table.q[i + 1] - table.q[i]);
        const double theta = table.theta[i] + share * (table.theta[i + 1] - table.theta[i]);
        CHECK(std::abs(look_up(theta - table.theta_initial) - q) <= 1e-3);
      }
      CHECK((table.theta[i + 1] > table.theta[i]) == (table.theta.back() > table.theta.front()));
    }
  }
}

TEST_CASE("the azimuth of the fingertip follows the table when the hand is solved by contact") {
  // the table was measured on the wrapped hand: the contact rule with delta r = 0 wraps it again
  const HandProfile& profile = real_profile();
  const BuildStages& stages = real_stages();
  for (std::size_t f = 0; f < stages.anatomy.fingers.size(); ++f) {
    const int t = stages.lateral_tables.table_of_finger[f];
    if (t < 0) continue;
    const LateralTable& table = stages.lateral_tables.tables[t];
    for (std::size_t i = 0; i < table.q.size(); i += 20) {
      std::vector<double> q = stages.lateral_tables.q_sphere;
      q[table.joint] = table.q[i];
      apply_mimics(stages.anatomy.tree, q);
      wrap_on_sphere(stages.anatomy, stages.sphere_frame, stages.joint_classes, stages.q_closed, q);
      const double azimuth =
          to_spherical(fingertip_in_sphere(stages.anatomy, stages.sphere_frame, static_cast<int>(f), q)).azimuth;
      CHECK(std::abs(wrap_angle((profile.mirrored ? -azimuth : azimuth) - table.theta[i])) < 1e-9);
    }
  }
}
