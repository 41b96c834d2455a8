#include "uhas/collision/self_collision.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/error_check.hpp"
#include "support/sliding_boxes.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

const TriangleMesh kCube = make_box({}, {0.02, 0.02, 0.02});

LinkPairUse use_of(const SelfCollision& collision, int first, int second) {
  for (const LinkPair& pair : collision.pairs())
    if (pair.first == first && pair.second == second) return pair.use;
  FAIL("no such pair");
  return {};
}

}  // namespace

TEST_CASE("links that hold together are left out, also across joints without geometry") {
  SlidingBoxes hand;
  hand.add_link(make_box({0, 0, -1}, {0.02, 0.02, 0.02}), -1);  // 0, palm
  const int first = hand.add(kCube, 0);                         // 1
  hand.add_link(kCube, first);                                  // 2
  const int empty = hand.add({}, 0, first);                     // 3
  const int far = hand.add(kCube, 0, empty);                    // 4
  hand.add(kCube, 0, far);                                      // 5
  hand.add(kCube, 0);                                           // 6
  const SelfCollision collision(hand.profile, hand.geometry);

  CHECK(use_of(collision, 0, 1) == LinkPairUse::adjacent);
  CHECK(use_of(collision, 0, 6) == LinkPairUse::adjacent);
  CHECK(use_of(collision, 1, 2) == LinkPairUse::adjacent);
  CHECK(use_of(collision, 1, 4) == LinkPairUse::adjacent);
  CHECK(use_of(collision, 4, 5) == LinkPairUse::adjacent);
  CHECK(use_of(collision, 1, 5) == LinkPairUse::checked);
  CHECK(use_of(collision, 1, 6) == LinkPairUse::checked);
  CHECK(use_of(collision, 5, 6) == LinkPairUse::checked);
  CHECK(use_of(collision, 0, 5) == LinkPairUse::apart);
  CHECK(collision.pairs().size() == 6 * 5 / 2);
}

TEST_CASE("what touches in nearly all poses is left out, what touches in none has no distance") {
  SlidingBoxes hand;
  hand.add(kCube, 0, -1, -0.005, 0.005);                                       // 0
  hand.add(make_box({0.01, 0, 0}, {0.02, 0.02, 0.02}), 0, -1, -0.005, 0.005);  // 1: at most 20 mm from 0
  hand.add(make_box({0, 0.03, 0}, {0.02, 0.02, 0.02}), 0, -1, -0.005, 0.005);  // 2: 10 mm beside both
  hand.add(make_box({0.07, 0, 0}, {0.02, 0.02, 0.02}), 0, -1, -0.06, 0);       // 3
  const SelfCollision collision(hand.profile, hand.geometry);
  CHECK(use_of(collision, 0, 1) == LinkPairUse::touching);
  CHECK(use_of(collision, 0, 2) == LinkPairUse::apart);
  CHECK(use_of(collision, 0, 3) == LinkPairUse::checked);

  const std::vector<double> q{0, 0, 0, -0.01};
  CHECK_FALSE(collision.collides(q));
  const NearestLinks nearest = collision.nearest(q);
  CHECK(nearest.first == 1);
  CHECK(nearest.second == 3);
  CHECK(std::abs(nearest.distance - 0.03) < 1e-12);
  CHECK_FALSE(nearest.colliding);
}

TEST_CASE("a contact that the sample has missed is seen") {
  SlidingBoxes hand;
  hand.add(kCube, 0);
  hand.add(kCube, 0.4);
  const SelfCollision collision(hand.profile, hand.geometry, {.samples = 0});
  REQUIRE(use_of(collision, 0, 1) == LinkPairUse::apart);
  CHECK(collision.nearest(std::vector<double>{0, 0.4}).first == -1);
  CHECK(std::isinf(collision.nearest(std::vector<double>{0, 0.4}).distance));

  const std::vector<double> q{0, 0.01};
  CHECK(collision.collides(q));
  CHECK(collision.colliding_pairs(q) == std::vector<int>{0});
  const NearestLinks nearest = collision.nearest(q);
  CHECK(nearest.colliding);
  CHECK(nearest.distance == 0);
  CHECK(nearest.first == 0);
  CHECK(nearest.second == 1);
}

TEST_CASE("all pairs in contact are named, by one that was assigned too") {
  SlidingBoxes hand, other;
  for (int i = 0; i < 4; ++i) hand.add(kCube, 0.1 * i);
  for (int i = 0; i < 2; ++i) other.add(kCube, 0.1 * i);
  SelfCollision collision(other.profile, other.geometry);
  collision = SelfCollision(hand.profile, hand.geometry);
  REQUIRE(collision.pairs().size() == 6);  // 01 02 03 12 13 23
  CHECK(collision.colliding_pairs(std::vector<double>{0, 0.1, 0.2, 0.3}).empty());
  CHECK(collision.colliding_pairs(std::vector<double>{0, 0.015, 0.03, 0.3}) == std::vector<int>{0, 3});
  CHECK(std::abs(collision.nearest(std::vector<double>{0, 0.1, 0.2, 0.25}).distance - 0.03) < 1e-12);
}

TEST_CASE("mimic followers keep to their masters in the sample") {
  SlidingBoxes hand;
  hand.add(kCube, 0, -1, 0, 0.1);
  hand.add(kCube, 0.03, -1, -0.5, 0.5);
  hand.profile.tree.joints[1].mimic_master = 0;  // always 30 mm ahead
  hand.profile.tree.joints[1].mimic_offset = 0.03;
  CHECK(use_of(SelfCollision(hand.profile, hand.geometry), 0, 1) == LinkPairUse::apart);
}

TEST_CASE("too many triangles are simplified, and no link is lost") {
  SlidingBoxes hand;
  hand.add(kCube, 0);
  hand.add(kCube, 0.4);
  const SelfCollision collision(hand.profile, hand.geometry, {.max_triangles = 1});
  CHECK(collision.collides(std::vector<double>{0, 0.01}));
  CHECK_FALSE(collision.collides(std::vector<double>{0, 0.03}));
}

TEST_CASE("options and geometry that make no sense are refused") {
  SlidingBoxes hand;
  hand.add(kCube, 0);
  const auto build = [&hand](const SelfCollisionOptions& options) {
    SelfCollision(hand.profile, hand.geometry, options);
  };
  check_error(ErrorCode::invalid_option, "samples must not be negative", [&] { build({.samples = -1}); });
  check_error(ErrorCode::invalid_option, "touching_share must lie in (0, 1]", [&] { build({.touching_share = 0}); });
  hand.geometry.links.clear();
  check_error(ErrorCode::invalid_option, "the geometry is not that of the profile", [&] { build({}); });
}
