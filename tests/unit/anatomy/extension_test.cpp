#include "uhas/anatomy/opening/extension.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "toy_skeleton.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

struct Extended {
  BaseAngle base;
  std::vector<double> q;
};

/// Extends a finger that closes by positive turns.
Extended extend(const KinematicTree& tree, const FingerSkeleton& finger, const BaseEvidence& evidence = {}) {
  Extended result{{}, std::vector<double>(tree.joints.size(), 0.0)};
  const Flexion flexion{find_flexion_joints(tree, finger), {1, 1}};
  result.base = extend_finger(tree, finger, flexion, evidence, result.q);
  return result;
}

}  // namespace

TEST_CASE("base angle: a zero that the designer called straight") {
  KinematicTree tree;
  const Extended found = extend(tree, add_hinges(tree, -1, {}, {-0.5, 1.1}), {.zero_is_straight = true, .slab = {}});
  CHECK(found.q == std::vector<double>{0, 0, 0});
  CHECK(found.base.error == doctest::Approx(0.09));
  CHECK_FALSE(found.base.is_guess);
}

TEST_CASE("base angle: straight with a metacarpal") {
  KinematicTree tree;
  const FingerSkeleton finger = add_hinges_behind(tree, kZ, {-0.3, 0.3}, {}, {-0.8, 1.6}, 0.04);
  const Extended found = extend(tree, finger);
  CHECK(std::abs(found.q[1]) < 1e-3);
  CHECK_FALSE(found.base.is_guess);
}

TEST_CASE("base angle: just short of the open end, a guess") {
  KinematicTree tree;
  const Extended found = extend(tree, add_hinges(tree, -1, {}, {-0.2, 1.6}));
  CHECK(found.q[0] == doctest::Approx(-0.05));
  CHECK(found.base.error == doctest::Approx(0.16 * 1.8));
  CHECK(found.base.is_guess);
}

TEST_CASE("base angle: square to the palm's slab") {
  KinematicTree tree;
  const FingerSkeleton finger = add_hinges(tree, -1, {}, {-0.2, 1.6});
  const Extended found = extend(tree, finger, {.slab = PalmSlab{kX, 0.12}});
  CHECK(std::abs(found.q[0]) < 1e-12);
  CHECK(found.base.error == 0.12);
  CHECK_FALSE(found.base.is_guess);

  // 40 degrees from where the finger seems to be, or beside its plane, a slab tells nothing
  for (const Vector3d& normal : {Vector3d{std::cos(0.7), 0, std::sin(0.7)}, kY})
    CHECK(extend(tree, finger, {.slab = PalmSlab{normal, 0.12}}).base.is_guess);
}

TEST_CASE("base angle: a side joint is a second witness, before which a guess gives way") {
  KinematicTree tree;
  const FingerSkeleton finger = add_hinges_behind(tree, kX, {-0.3, 0.3}, {}, {-0.2, 1.6});
  const Extended guessed = extend(tree, finger);
  CHECK(std::abs(guessed.q[1]) < 1e-12);
  CHECK(guessed.base.error == doctest::Approx(0.09));
  CHECK_FALSE(guessed.base.is_guess);

  const Vector3d tilted{std::cos(0.3), 0, std::sin(0.3)};  // by 0.3 rad toward opening
  const Extended averaged = extend(tree, finger, {.slab = PalmSlab{tilted, 0.12}});
  CHECK(averaged.q[1] == doctest::Approx(-0.1));  // half of the way from the open end, -0.2, to the side joint's zero
  CHECK(averaged.base.error == doctest::Approx(0.1));
}

TEST_CASE("a jaw is extended at its open end") {
  KinematicTree tree;
  const FingerSkeleton jaw{{add_slide(tree, -1, 0.03 * kY, -1.0 * kY, -0.02, 0.01)}, 0.05 * kZ};
  CHECK(extend(tree, jaw).q[0] == -0.02);
}

TEST_CASE("a shared joint stands in the middle of what its fingers want, a held one where it is") {
  HandSkeleton hand;
  const int shared = add_hinge(hand.tree, -1, {}, kY, -1, 1.6);
  HandMotion motion;
  for (const double bent : {0.0, 0.4}) {  // square to the slab where the joint is at 0 and at -0.4
    const Vector3d along{std::sin(bent), 0, std::cos(bent)};
    const int next = add_hinge(hand.tree, shared, 0.05 * along, kX, -0.1, 0.1);
    hand.fingers.push_back({{shared, next}, 0.05 * along});
    motion.flexions.push_back({find_flexion_joints(hand.tree, hand.fingers.back()), {1, 1}});
  }
  motion.held.assign(3, false);
  CHECK(motion.flexions[0].positions == std::vector<int>{0});
  motion.slab = PalmSlab{kX, 0.1};
  const std::vector<double> q{0.1, 0, 0};
  const ExtendedHand extended = extend_hand(hand, motion, q);
  CHECK(extended.bases.size() == 2);
  CHECK(extended.postures.size() == 2);
  CHECK(extended.q[shared] == doctest::Approx(-0.2));
  CHECK(extended.q[1] == 0);  // other joints keep their values

  motion.held[shared] = true;
  const ExtendedHand held = extend_hand(hand, motion, q);
  CHECK(held.q[shared] == 0.1);
  CHECK(held.bases[0].error == 0);
  CHECK(held.bases[1].error == 0);
}
