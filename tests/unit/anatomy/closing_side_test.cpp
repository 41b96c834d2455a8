#include "uhas/anatomy/opening/closing_side.hpp"

#include <doctest/doctest.h>

#include "toy_skeleton.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

ClosingSide closing_side(const KinematicTree& tree, const FingerSkeleton& finger, Vector3d hand_center = {}) {
  return find_closing_side(tree, finger, find_flexion_joints(tree, finger), hand_center, false);
}

}  // namespace

TEST_CASE("a finger closes to the side of the larger range") {
  for (const double sign : {1.0, -1.0}) {
    KinematicTree tree;
    const ToyLimits limits = sign > 0 ? ToyLimits{-0.2, 1.6} : ToyLimits{-1.6, 0.2};
    const ClosingSide side = closing_side(tree, add_hinges(tree, -1, {}, limits));
    CHECK(side.sign == sign);
    CHECK(side.evidence == doctest::Approx(1.4 / 1.8));
  }
}

TEST_CASE("where only the base can tell, it is extended as it points away from the hand's middle") {
  KinematicTree tree;
  const FingerSkeleton finger = add_hinges(tree, -1, 0.05 * kX, {-2, 0.6}, kZ, kY, {0.1});
  const ClosingSide side = closing_side(tree, finger);
  CHECK(side.sign == -1);
  CHECK(side.evidence == doctest::Approx(0.3));
  CHECK(closing_side(tree, finger, 0.1 * kX).sign == 1);
}

TEST_CASE("the base is asked from its zero when the hand is straight at zero") {
  KinematicTree tree;
  const FingerSkeleton finger = add_hinges(tree, -1, 0.05 * kX, {-0.5, 1.5}, kZ, kY, {0.1});
  const ClosingSide side = find_closing_side(tree, finger, find_flexion_joints(tree, finger), {}, true);
  CHECK(side.sign == 1);
  CHECK(side.evidence == doctest::Approx(0.5));
}

TEST_CASE("a jaw closes toward the middle of the hand") {
  KinematicTree tree;
  const FingerSkeleton left{{add_slide(tree, -1, 0.03 * kY, kY, 0, 0.02)}, 0.05 * kZ};
  const FingerSkeleton right{{add_slide(tree, -1, -0.03 * kY, kY, -0.02, 0)}, 0.05 * kZ};
  CHECK(closing_side(tree, left, 0.05 * kZ).sign == -1);
  CHECK(closing_side(tree, right, 0.05 * kZ).sign == 1);
  CHECK(closing_side(tree, right, 0.05 * kZ).evidence == 1);
}

TEST_CASE("neighbours vote, by their evidence; a finger across the palm does not") {
  HandSkeleton hand;
  for (const double y : {-0.02, 0.0, 0.02}) hand.fingers.push_back(add_hinges(hand.tree, -1, y * kY));
  hand.fingers.push_back(add_hinges(hand.tree, -1, 0.05 * kX));
  std::vector<Flexion> flexions;
  for (const FingerSkeleton& finger : hand.fingers)
    flexions.push_back({find_flexion_joints(hand.tree, finger), {1, 0.6}});
  flexions[1].closing = {-1, 0.3};
  flexions[3].closing = {-1, 0.3};

  const std::vector<ClosingSide> agreed = agree_on_closing_side(hand, flexions);
  CHECK(agreed[0].sign == 1);
  CHECK(agreed[1].sign == 1);
  CHECK(agreed[2].sign == 1);
  CHECK(agreed[1].evidence == doctest::Approx(0.3));  // |0.3 - 0.6 - 0.6| / 3
  CHECK(agreed[3].sign == -1);
  CHECK(agreed[3].evidence == doctest::Approx(0.3));
}
