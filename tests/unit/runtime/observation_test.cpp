// The observation on the small profile: a left hand with a mimic follower, a sliding joint and shared slots.
#include "uhas/runtime/observation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/mirrored_profile.hpp"
#include "support/small_profile.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

using namespace uhas;

namespace {

constexpr ObservationOptions kEverything{.points = {true, true, true, true, true, true, true}, .pad_directions = true};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Motion {
  std::vector<double> q, qd;
};

Motion random_motion(const HandProfile& profile, std::mt19937_64& random) {
  Motion motion;
  for (const Joint& joint : profile.tree.joints) {
    motion.q.push_back(std::uniform_real_distribution(joint.lower, joint.upper)(random));
    motion.qd.push_back(std::uniform_real_distribution(-3.0, 3.0)(random));
  }
  return motion;
}

template <class Real = double>
std::vector<Real> observe(const HandProfile& profile, const Motion& motion, const ObservationOptions& options = {}) {
  Observer<Real> observer(profile, options);
  const std::vector<Real> q(motion.q.begin(), motion.q.end()), qd(motion.qd.begin(), motion.qd.end());
  std::vector<Real> observation(observer.size());
  REQUIRE(observer.observe(q, qd, observation) == Status::ok);
  return observation;
}

Vector3d vector_at(const std::vector<double>& observation, std::size_t at) {
  return {observation[at], observation[at + 1], observation[at + 2]};
}

/// Every joint's moved frame in S, `seconds` later at constant rates of the independent joints.
std::vector<RigidTransformd> frames_in_sphere(const HandProfile& profile, const Motion& motion, double seconds = 0) {
  std::vector<double> q = motion.q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += seconds * motion.qd[i];
  apply_mimics(profile.tree, q);
  std::vector<RigidTransformd> T(q.size());
  forward_kinematics(profile.tree, q, T);
  for (RigidTransformd& frame : T) frame = profile.T_palm_sphere.inverse() * frame;
  return T;
}

/// The owner of each slot of the small profile.
constexpr std::array<int, kSlotCount> kOwners{0, 0, 0, 0, 1};

Vector3d mirrored(Vector3d a) { return {a.x, -a.y, a.z}; }

}  // namespace

TEST_CASE("positions, velocities and pad directions are those of the hand's frames, mirrored on a left hand") {
  constexpr double h = 1e-5;  // s, of central differences
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(1);
  for (int n = 0; n < 100; ++n) {
    const Motion motion = random_motion(profile, random);
    const std::vector<double> observation = observe(profile, motion, kEverything);
    REQUIRE(observation.size() == 5 * 7 * 9 + 5 * 3);
    const auto before = frames_in_sphere(profile, motion, -h), now = frames_in_sphere(profile, motion),
               after = frames_in_sphere(profile, motion, h);
    for (std::size_t slot = 0; slot < kSlotCount; ++slot) {
      const auto points = finger_points(profile, kOwners[slot]);
      for (std::size_t k = 0; k < kFingerPoints; ++k) {
        const auto [joint, p] = points[k];
        const Vector3d velocity = (after[joint] * p - before[joint] * p) / (2 * h * profile.radius);
        const auto W = (after[joint].rotation * before[joint].rotation.transposed()).m;  // about 1 + 2 h [angular]x
        const Vector3d angular = Vector3d{W[7] - W[5], W[2] - W[6], W[3] - W[1]} / (4 * h);
        const std::size_t at = 9 * (7 * slot + k);
        CHECK(norm(vector_at(observation, at) - mirrored(now[joint] * p / profile.radius)) < 1e-12);
        CHECK(norm(vector_at(observation, at + 3) - mirrored(velocity)) < 1e-6);
        CHECK(norm(vector_at(observation, at + 6) + mirrored(angular)) < 1e-6);
      }
      const ProfileFinger& finger = profile.fingers[kOwners[slot]];
      const ProfileLink& tip = profile.links[finger.tip_link];
      const Vector3d pad = now[tip.joint].rotation * (tip.T_joint_link.rotation * finger.pad_normal_link);
      CHECK(norm(vector_at(observation, 5 * 7 * 9 + 3 * slot) - mirrored(pad)) < 1e-12);
    }
  }
}

TEST_CASE("a hand and its mirror image are observed alike") {
  const HandProfile profile = test::small_profile(), image = test::mirror_image(profile);
  std::mt19937_64 random(2);
  for (int n = 0; n < 100; ++n) {
    const Motion motion = random_motion(profile, random);
    const std::vector<double> a = observe(profile, motion, kEverything), b = observe(image, motion, kEverything);
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(1e-12));
  }
}

TEST_CASE("the default is the fourth and the seventh point, without pad directions") {
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(3);
  const Motion motion = random_motion(profile, random);
  const std::vector<double> all = observe(profile, motion, kEverything), chosen = observe(profile, motion);
  REQUIRE(chosen.size() == 90);
  for (std::size_t slot = 0; slot < kSlotCount; ++slot)
    for (std::size_t i = 0; i < 9; ++i) {
      CHECK(chosen[18 * slot + i] == all[63 * slot + 27 + i]);
      CHECK(chosen[18 * slot + 9 + i] == all[63 * slot + 54 + i]);
    }
}

TEST_CASE("a finger stands in each of its slots, and of fingers that share slots each in one") {
  HandProfile profile = test::small_profile();
  std::mt19937_64 random(4);
  const Motion motion = random_motion(profile, random);
  const auto slot_of = [](const std::vector<double>& observation, int slot) {
    return std::vector<double>(observation.begin() + 18 * slot, observation.begin() + 18 * (slot + 1));
  };
  const std::vector<double> separate = observe(profile, motion);
  const auto index = slot_of(separate, 0), thumb = slot_of(separate, 4);
  CHECK(index != thumb);
  for (int slot : {1, 2, 3}) CHECK(slot_of(separate, slot) == index);

  profile.fingers[1].slots = {true, true, false, false, true};
  const std::vector<double> shared = observe(profile, motion);
  for (int slot : {0, 2, 3}) CHECK(slot_of(shared, slot) == index);
  for (int slot : {1, 4}) CHECK(slot_of(shared, slot) == thumb);
}

TEST_CASE("mimic followers follow their masters, whatever the caller writes there") {
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(5);
  Motion motion = random_motion(profile, random);
  const std::vector<double> expected = observe(profile, motion);
  motion.q[2] = motion.qd[2] = kNaN;
  CHECK(observe(profile, motion) == expected);
}

template <class Real>
void check_batches(double tolerance) {
  for (const HandProfile& profile : {test::small_profile(), test::mirror_image(test::small_profile())}) {
    std::mt19937_64 random(6);
    std::vector<Real> q, qd;
    std::vector<double> expected;
    constexpr std::size_t hands = 21;  // no multiple of any number of lanes
    for (std::size_t n = 0; n < hands; ++n) {
      const Motion motion = random_motion(profile, random);
      const std::vector<double> one = observe(profile, motion, kEverything);
      q.insert(q.end(), motion.q.begin(), motion.q.end());
      qd.insert(qd.end(), motion.qd.begin(), motion.qd.end());
      expected.insert(expected.end(), one.begin(), one.end());
    }
    for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2}) {
      if (!is_available(set)) {
        MESSAGE("SKIPPED: ", to_string(set), ", which this processor has not");
        continue;
      }
      Observer<Real> observer(profile, kEverything, set), copy = observer;
      const std::size_t joints = observer.joint_count(), size = observer.size();
      for (Observer<Real>* each : {&observer, &copy}) {
        for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(8), hands}) {
          std::vector<Real> observations(count * size);
          const auto first = [&](const std::vector<Real>& of) { return std::span(of).first(count * joints); };
          REQUIRE(each->observe_batch(first(q), first(qd), observations) == Status::ok);
          for (std::size_t i = 0; i < observations.size(); ++i)
            REQUIRE(std::abs(double(observations[i]) - expected[i]) <= tolerance);
        }
      }
    }
  }
}

TEST_CASE("a batch is its hands one by one on every instruction set, and a copy observes alike") {
  check_batches<double>(1e-12);
  check_batches<float>(3e-5);
}

TEST_CASE("float and double agree") {
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(7);
  for (int n = 0; n < 100; ++n) {
    const Motion motion = random_motion(profile, random);
    const std::vector<double> exact = observe(profile, motion, kEverything);
    const std::vector<float> rounded = observe<float>(profile, motion, kEverything);
    for (std::size_t i = 0; i < exact.size(); ++i) CHECK(std::abs(double(rounded[i]) - exact[i]) < 2e-5);
  }
}

TEST_CASE("wrong sizes and numbers that are not finite are refused and leave the output untouched") {
  Observer<double> observer(test::small_profile());
  REQUIRE(observer.joint_count() == 5);
  REQUIRE(observer.size() == 90);
  std::vector<double> output(2 * 90, 42.0);
  const std::span<double> one(output.data(), 90), two(output);
  const std::vector<double> q5(5, 0.1), q4(4, 0.1), q10(10, 0.1);

  CHECK(observer.observe(q4, q5, one) == Status::wrong_size);
  CHECK(observer.observe(q5, q4, one) == Status::wrong_size);
  CHECK(observer.observe(q5, q5, one.first(89)) == Status::wrong_size);
  CHECK(observer.observe(q10, q10, two) == Status::wrong_size);
  CHECK(observer.observe_batch(q10, q5, two) == Status::wrong_size);
  CHECK(observer.observe_batch(q10, q10, one) == Status::wrong_size);
  CHECK(observer.observe_batch(q4, q4, one) == Status::wrong_size);
  for (double bad : {kNaN, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    std::vector<double> bad5 = q5, bad10 = q10;
    bad5[4] = bad10[9] = bad;
    CHECK(observer.observe(bad5, q5, one) == Status::non_finite_input);
    CHECK(observer.observe(q5, bad5, one) == Status::non_finite_input);
  }
  CHECK(output == std::vector<double>(2 * 90, 42.0));
}

TEST_CASE("a profile that is not valid is refused") {
  HandProfile profile = test::small_profile();
  profile.radius = 0;
  CHECK_THROWS_AS(Observer<double>{profile}, Error);
}
