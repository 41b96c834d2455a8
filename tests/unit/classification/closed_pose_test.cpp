#include "uhas/classification/closed_pose.hpp"

#include <doctest/doctest.h>

#include "support/error_check.hpp"
#include "support/sphere_hand.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

std::vector<double> closed_pose(const SphereHand& hand, const std::map<std::string, double>& stated = {}) {
  HandConfig config;
  config.q_closed = stated;
  return find_closed_pose(hand.anatomy, hand.frame, config);
}

}  // namespace

TEST_CASE("a finger closes toward the sphere's centre, whichever way its axes point and whichever range is larger") {
  for (const double sign : {1.0, -1.0}) {
    for (const auto& ranges : {std::pair(1.5, 1.5), std::pair(1.7, 0.4), std::pair(0.1, 1.6)}) {
      const double back = ranges.first, closing = ranges.second;
      SphereHand hand;
      add_planar_finger(hand, {.back = back, .closing = closing, .sign = sign});
      CAPTURE(sign);
      CAPTURE(closing);
      CHECK(closed_pose(hand) == std::vector<double>(3, sign * closing));
    }
  }
}

TEST_CASE("limits on one side of zero: the end that leads toward the centre from the open pose") {
  for (const double sign : {1.0, -1.0}) {
    SphereHand hand;
    add_planar_finger(hand, {.lengths = {1.2}, .back = -0.2, .closing = 1.0, .sign = sign});
    hand.anatomy.q_open = {sign * 0.3};
    CHECK(closed_pose(hand) == std::vector<double>{sign * 1.0});
  }
}

TEST_CASE("the nearest approach on the way counts, not the distance at the end") {
  // from open at 1.2 the tip passes the centre at 0.16 radii and ends at 1.31; at the other end it is at 0.95
  SphereHand hand;
  add_planar_finger(hand, {.lengths = {1.2}, .back = -1.0, .closing = 3.1});
  hand.anatomy.q_open = {1.2};
  REQUIRE(norm(hand.tip(0, {3.1})) > norm(hand.tip(0, {1.0})));
  CHECK(closed_pose(hand) == std::vector<double>{3.1});
}

TEST_CASE("the joints further out stand open while a joint is swept") {
  // seen from the root, the centre stands at 107 degrees: straight the tip starts below that, bent by 2.6 rad at 120
  SphereHand hand;
  add_planar_finger(hand, {.lengths = {0.5, 0.9}, .back = 0.5, .closing = 3.0});
  CHECK(closed_pose(hand)[0] == 3.0);
  hand.anatomy.q_open = {0, 2.6};
  CHECK(closed_pose(hand)[0] == -0.5);
}

namespace {

/// A finger whose one joint turns it about an axis through the centre, so that its tip keeps its distance.
SphereHand tied_hand(Vector3d axis, double lower, double upper) {
  SphereHand hand;
  hand.add_finger({add_hinge(hand.tree(), -1, {0, 0, -1}, axis, lower, upper)}, {1.2, 0, -1});
  return hand;
}

}  // namespace

TEST_CASE("on a tie the larger range wins") {
  CHECK(closed_pose(tied_hand({0, 0, 1}, -0.2, 0.5)) == std::vector<double>{0.5});
  CHECK(closed_pose(tied_hand({0, 0, 1}, -0.5, 0.2)) == std::vector<double>{-0.5});
}

TEST_CASE("of equal ranges the same side wins whichever way the axis points, on the image of the hand its image") {
  CHECK(closed_pose(tied_hand({0, 0, -1}, -0.4, 0.4)) == std::vector<double>{0.4});
  CHECK(closed_pose(tied_hand({0, 0, 1}, -0.4, 0.4)) == std::vector<double>{-0.4});
  CHECK(closed_pose(mirrored(tied_hand({0, 0, -1}, -0.4, 0.4))) == std::vector<double>{0.4});
}

TEST_CASE("a joint that moves two fingers closes to the side where their mean distance is least") {
  // turning up brings the far tip nearer, turning down the near one, but by less
  SphereHand hand;
  const int arch = add_hinge(hand.tree(), -1, {0, 0, -1}, {1, 0, 0}, -0.3, 0.3);
  hand.add_finger({arch}, {0.8, 0.9, -1});
  hand.add_finger({arch}, {0.8, -0.2, -1});
  CHECK(closed_pose(hand) == std::vector<double>{0.3});
}

TEST_CASE("followers stand where their master puts them") {
  SphereHand hand;
  const int master = add_hinge(hand.tree(), -1, {0.3, 0, -1}, {0, -1, 0}, -0.2, 1.5);
  const int follower = add_follower(hand.tree(), master, {0.8, 0, -1}, {0, 1, 0}, master, -0.5);
  hand.add_finger({master, follower}, {1.2, 0, -1});
  CHECK(closed_pose(hand) == std::vector<double>{1.5, -0.75});
}

TEST_CASE("a config's value wins and is checked") {
  SphereHand hand;
  add_planar_finger(hand, {});
  CHECK(closed_pose(hand, {{"j1", 1.1}}) == std::vector<double>{1.8, 1.1, 1.8});
  check_error(ErrorCode::invalid_config, "outside the limits of \"j1\"", [&] { closed_pose(hand, {{"j1", 1.9}}); });
  check_error(ErrorCode::invalid_config, "\"j7\"", [&] { closed_pose(hand, {{"j7", 0}}); });
}

TEST_CASE("the scale of the hand does not matter") {
  SphereHand hand;
  add_planar_finger(hand, {.sign = -1});
  const int side = add_hinge(hand.tree(), -1, {0, 0, -1}, {0, 0, 1}, -0.5, 0.2);
  hand.add_finger({side}, {1.2, 0, -1});
  for (const double factor : {1e-3, 0.08, 1e3}) CHECK(closed_pose(scaled(hand, factor)) == closed_pose(hand));
}
