// The fingertips against the frames of forward_kinematics(), which is held to KDL.
#include "uhas/runtime/fingertip_kinematics.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

#include "support/arch_profile.hpp"
#include "support/mirrored_profile.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/forward_kinematics.hpp"

using namespace uhas;

namespace {

/// Followers hold nonsense: nobody is to read them.
std::vector<double> random_posture(const HandProfile& profile, std::mt19937_64& random) {
  std::vector<double> q;
  for (const Joint& joint : profile.tree.joints)
    q.push_back(joint.mimic_master >= 0 ? std::numeric_limits<double>::quiet_NaN()
                                        : std::uniform_real_distribution(joint.lower - 0.5, joint.upper + 0.5)(random));
  return q;
}

/// [finger][3] m, in the palm frame.
std::vector<double> expected_fingertips(const HandProfile& profile, std::vector<double> q) {
  apply_mimics(profile.tree, q);
  std::vector<RigidTransformd> T_palm_joint(q.size());
  forward_kinematics(profile.tree, q, T_palm_joint);
  std::vector<double> expected;
  for (const ProfileFinger& finger : profile.fingers) {
    const ProfileLink& tip = profile.links[finger.tip_link];
    const Vector3d p = T_palm_joint[tip.joint] * (tip.T_joint_link * finger.p_tip_link);
    expected.insert(expected.end(), {p.x, p.y, p.z});
  }
  return expected;
}

/// A hand with a joint whose axis is its parent's, turned the same way and the other way round: no tilt to tell the two
/// turns about it apart, and one of half a turn.
HandProfile parallel_axes_profile() {
  HandProfile profile = test::small_profile();
  profile.tree.joints[1].T_parent_joint.rotation = {};
  profile.tree.joints[1].axis = profile.tree.joints[0].axis;
  profile.tree.joints[2].T_parent_joint.rotation = {};
  profile.tree.joints[2].axis = -profile.tree.joints[1].axis;
  return profile;
}

std::vector<HandProfile> hands() {
  return {test::small_profile(), test::mirror_image(test::small_profile()), test::arch_profile(),
          parallel_axes_profile()};
}

template <class Real>
void check_against_frames(double tolerance) {
  std::mt19937_64 random(1);
  for (const HandProfile& profile : hands()) {
    const FingertipKinematics<Real> kinematics(profile);
    REQUIRE(kinematics.joint_count() == int(profile.tree.joints.size()));
    REQUIRE(kinematics.finger_count() == int(profile.fingers.size()));
    double worst = 0;
    for (int n = 0; n < 1000; ++n) {
      const std::vector<double> q = random_posture(profile, random), expected = expected_fingertips(profile, q);
      const std::vector<Real> q_real(q.begin(), q.end());
      std::vector<Real> found(expected.size());
      REQUIRE(kinematics.fingertips(q_real, found) == Status::ok);
      for (std::size_t i = 0; i < found.size(); ++i) worst = std::max(worst, std::abs(double(found[i]) - expected[i]));
    }
    CAPTURE(profile.hand);
    CHECK(worst <= tolerance);
  }
}

}  // namespace

TEST_CASE("fingertips are where the frames put them") {
  check_against_frames<double>(1e-14);
  check_against_frames<float>(1e-6);
}

TEST_CASE("a batch gives what single calls give") {
  std::mt19937_64 random(2);
  for (const HandProfile& profile : hands()) {
    const FingertipKinematics<float> kinematics(profile);
    const std::size_t joints = kinematics.joint_count(), numbers = 3 * kinematics.finger_count();
    for (std::size_t count : {0, 1, 7, 8, 9, 64, 100}) {
      std::vector<float> q;
      for (std::size_t n = 0; n < count; ++n)
        for (double value : random_posture(profile, random)) q.push_back(static_cast<float>(value));
      std::vector<float> batch(count * numbers), one(numbers);
      REQUIRE(kinematics.fingertips_batch(q, batch) == Status::ok);
      for (std::size_t n = 0; n < count; ++n) {
        REQUIRE(kinematics.fingertips(std::span(q).subspan(n * joints, joints), one) == Status::ok);
        for (std::size_t i = 0; i < numbers; ++i) CHECK(std::abs(batch[n * numbers + i] - one[i]) <= 1e-6f);
      }
    }
  }
}

TEST_CASE("what is refused leaves the output untouched") {
  const HandProfile profile = test::small_profile();
  const FingertipKinematics<double> kinematics(profile);
  std::vector<double> q(10, 0.1), fingertips(12, 7.0);
  const auto check = [&](std::size_t numbers, std::size_t outputs, Status expected) {
    CHECK(kinematics.fingertips_batch(std::span(q).first(numbers), std::span(fingertips).first(outputs)) == expected);
    CHECK(fingertips == std::vector<double>(12, 7.0));
  };
  check(9, 12, Status::wrong_size);
  check(10, 6, Status::wrong_size);
  q[8] = std::numeric_limits<double>::infinity();
  check(10, 12, Status::non_finite_input);
  CHECK(kinematics.fingertips(q, fingertips) == Status::wrong_size);

  HandProfile invalid = profile;
  invalid.radius = -1;
  CHECK_THROWS_AS(FingertipKinematics<double>{invalid}, Error);
}
