// The fingertips against the frames of forward_kinematics(), which is held to KDL.
#include "uhas/runtime/fingertip_kinematics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

#include "support/arch_profile.hpp"
#include "support/mirrored_profile.hpp"
#include "support/small_profile.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

using namespace uhas;

namespace {

/// Followers hold `nonsense`: nobody is to read them.
std::vector<double> random_posture(const HandProfile& profile, std::mt19937_64& random, double nonsense = 99) {
  std::vector<double> q;
  for (const Joint& joint : profile.tree.joints)
    q.push_back(joint.mimic_master >= 0 ? nonsense
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

/// More joints and fingertip coordinates than any instruction set has lanes, and no multiple of them.
HandProfile long_finger_profile() {
  HandProfile profile = test::small_profile();
  ProfileFinger& thumb = profile.fingers[1];
  for (int i = 0; i < 6; ++i) {
    Joint joint = profile.tree.joints[1];
    joint.name = "extra_" + std::to_string(i);
    joint.parent = thumb.joints.back();
    thumb.joints.push_back(static_cast<int>(profile.tree.joints.size()));
    profile.tree.joints.push_back(joint);
    profile.joint_traits.push_back(profile.joint_traits[1]);
  }
  profile.links[thumb.tip_link].joint = thumb.joints.back();
  return profile;
}

std::vector<HandProfile> hands() {
  return {test::small_profile(), test::mirror_image(test::small_profile()), test::arch_profile(),
          parallel_axes_profile(), long_finger_profile()};
}

std::vector<InstructionSet> available_sets() {
  std::vector<InstructionSet> sets{InstructionSet::scalar, InstructionSet::baseline};
  if (is_available(InstructionSet::avx2))
    sets.push_back(InstructionSet::avx2);
  else
    MESSAGE("SKIPPED: avx2, which this processor has not");
  return sets;
}

template <class Real>
double largest_error(std::span<const Real> found, std::span<const double> expected) {
  double worst = 0;
  for (std::size_t i = 0; i < found.size(); ++i) worst = std::max(worst, std::abs(double(found[i]) - expected[i]));
  return worst;
}

/// Single calls, and batches on every instruction set, of no hand, of one, and of more than fill the lanes.
template <class Real>
void check_against_frames(double tolerance) {
  std::mt19937_64 random(1);
  for (const HandProfile& profile : hands()) {
    std::vector<Real> q;
    std::vector<double> expected;
    constexpr std::size_t postures = 1003;
    for (std::size_t n = 0; n < postures; ++n) {
      const std::vector<double> posture = random_posture(profile, random), tips = expected_fingertips(profile, posture);
      q.insert(q.end(), posture.begin(), posture.end());
      expected.insert(expected.end(), tips.begin(), tips.end());
    }
    for (const InstructionSet set : available_sets()) {
      CAPTURE(profile.hand);
      CAPTURE(to_string(set));
      const FingertipKinematics<Real> kinematics(profile, set);
      const std::size_t joints = kinematics.joint_count(), numbers = 3 * kinematics.finger_count();
      REQUIRE(joints == profile.tree.joints.size());
      REQUIRE(numbers == 3 * profile.fingers.size());
      std::vector<Real> found(expected.size());
      for (std::size_t n = 0; n < postures; ++n)
        REQUIRE(kinematics.fingertips(std::span(q).subspan(n * joints, joints),
                                      std::span(found).subspan(n * numbers, numbers)) == Status::ok);
      CHECK(largest_error<Real>(found, expected) <= tolerance);
      for (const std::size_t hands_in_batch :
           {std::size_t(0), std::size_t(1), std::size_t(7), std::size_t(8), postures}) {
        found.assign(hands_in_batch * numbers, Real(7));
        REQUIRE(kinematics.fingertips_batch(std::span(q).first(hands_in_batch * joints), found) == Status::ok);
        CHECK(largest_error<Real>(found, expected) <= tolerance);
      }
    }
  }
}

}  // namespace

TEST_CASE("fingertips are where the frames put them") {
  check_against_frames<double>(1e-14);
  check_against_frames<float>(1e-6);
}

TEST_CASE("numbers that wide kernels do not take are treated one hand after the other") {
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(2);
  std::vector<double> q, expected;
  for (int n = 0; n < 20; ++n) {
    std::vector<double> posture = random_posture(profile, random, std::numeric_limits<double>::quiet_NaN());
    if (n == 13) posture[0] += 2 * std::numbers::pi * 1000;  // beyond 1000 rad
    const std::vector<double> tips = expected_fingertips(profile, posture);
    q.insert(q.end(), posture.begin(), posture.end());
    expected.insert(expected.end(), tips.begin(), tips.end());
  }
  for (const InstructionSet set : available_sets()) {
    std::vector<double> found(expected.size());
    REQUIRE(FingertipKinematics<double>(profile, set).fingertips_batch(q, found) == Status::ok);
    CHECK(largest_error<double>(found, expected) <= 1e-12);
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
  q[3] = q[8] = std::numeric_limits<double>::infinity();
  check(10, 12, Status::non_finite_input);
  CHECK(kinematics.fingertips(q, fingertips) == Status::wrong_size);

  HandProfile invalid = profile;
  invalid.radius = -1;
  CHECK_THROWS_AS(FingertipKinematics<double>{invalid}, Error);
}
