#include "uhas/anatomy/opening/open_hand.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "toy_skeleton.hpp"
#include "uhas/anatomy/opening/open_pose.hpp"
#include "uhas/anatomy/opening/thumb_side.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

struct Toy {
  HandSkeleton hand;
  HandMotion motion;

  void add(const FingerSkeleton& finger, ClosingSide closing = {1, 1}) {
    hand.fingers.push_back(finger);
    motion.flexions.push_back({find_flexion_joints(hand.tree, finger), closing});
    motion.held.assign(hand.tree.joints.size(), false);
  }

  ExtendedHand extended() const { return extend_hand(hand, motion, std::vector<double>(hand.tree.joints.size(), 0.3)); }

  std::vector<double> open_pose(Vector3d normal, Bases bases, bool opposing = false) const {
    return find_open_pose(hand, motion, extended(), -1, {normal, opposing, 1, {}, 0}, bases);
  }
};

}  // namespace

TEST_CASE("the open pose rolls a finger's pad to the normal; a gripper's fingers and held joints stay") {
  Toy toy;
  toy.motion.zero_is_straight = true;
  toy.add(add_hinges_behind(toy.hand.tree, kZ, {-2, 2}, {}));
  CHECK(toy.open_pose(kY, Bases::held)[0] == doctest::Approx(std::numbers::pi / 2).epsilon(0.01));
  CHECK(toy.open_pose(kY, Bases::held, true)[0] == 0.3);
  toy.motion.held[0] = true;
  CHECK(toy.open_pose(kY, Bases::held)[0] == 0.3);
}

TEST_CASE("a finger's base lies in the palm plane, once the normal is certain") {
  Toy toy;
  toy.add(add_hinges(toy.hand.tree, -1, {}, {-0.2, 1.6}));
  const double extended = toy.extended().q[0];
  CHECK(toy.open_pose(kX, Bases::held)[0] == extended);
  CHECK(std::abs(toy.open_pose(kX, Bases::searched)[0]) < 0.1);
  CHECK(std::abs(toy.open_pose(kX, Bases::searched)[0]) < std::abs(extended) + 1e-9);
}

TEST_CASE("a row of fingers: the normal, the open pose, and why") {
  Toy toy;
  toy.motion.zero_is_straight = true;
  for (const double y : {-0.02, 0.0, 0.02}) toy.add(add_hinges(toy.hand.tree, -1, y * kY));
  const Rotationd R_root_palm = Rotationd::about(kZ, std::numbers::pi / 2);
  const OpenHand open = open_hand(toy.hand, toy.motion, toy.extended(), -1, R_root_palm);
  CHECK(norm(open.palm_normal_palm - kX) < 1e-9);
  CHECK(norm(open.palm_normal_root - kY) < 1e-9);
  for (const double q : open.q) CHECK(q == 0);
  REQUIRE(open.findings.size() == 2);
  CHECK(open.findings[0].item == "palm_normal_in_root");
  CHECK(open.findings[0].value == "0.000 1.000 0.000");
  CHECK(open.findings[0].confidence > 0.8);
  CHECK(open.findings[1].item == "q_open");
  CHECK(open.findings[1].confidence == doctest::Approx(1));
}

TEST_CASE("a stated normal is believed, to the bit") {
  Toy toy;
  for (const double y : {-0.02, 0.0, 0.02}) toy.add(add_hinges(toy.hand.tree, -1, y * kY));
  HandConfig config;
  config.palm_normal_in_root = Vector3d{0.6, 0, 0.8};
  const OpenHand open = open_hand(toy.hand, toy.motion, toy.extended(), -1, {}, config);
  CHECK(open.palm_normal_root == *config.palm_normal_in_root);
  CHECK(open.findings[0].reason == kStatedInConfig);
}

TEST_CASE("a thumb closes to the side that faces the normal, unless its ranges tell more") {
  for (const double sign : {1.0, -1.0}) {
    Toy toy;
    toy.motion.zero_is_straight = true;
    for (const double y : {-0.02, 0.0, 0.02}) toy.add(add_hinges(toy.hand.tree, -1, y * kY));
    toy.add(add_hinges(toy.hand.tree, -1, 0.04 * kY, {-1, 1}, kY, kZ), {sign, 0});
    const TurnedThumb turned = turn_thumb(toy.hand, toy.motion, toy.extended(), 3, kX);
    CHECK(norm(turned.extended.postures[3].closing - kX) < 1e-9);
    CHECK(turned.motion.flexions[3].closing.sign == -1);
    CHECK(turned.margin == doctest::Approx(1));
    CHECK(norm(open_hand(toy.hand, toy.motion, toy.extended(), 3, {}).postures[3].closing - kX) < 1e-9);

    toy.motion.flexions[3].closing.evidence = 1.1;
    const TurnedThumb kept = turn_thumb(toy.hand, toy.motion, toy.extended(), 3, kX);
    CHECK(kept.motion.flexions[3].closing.sign == sign);
    CHECK(kept.margin == doctest::Approx(sign > 0 ? 0.1 : 2.1));
  }
}
