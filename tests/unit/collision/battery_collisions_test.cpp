#include "uhas/collision/battery_collisions.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/sliding_boxes.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("poses in self-collision are counted, by pair too, for any number of threads") {
  const TriangleMesh cube = make_box({}, {0.02, 0.02, 0.02});
  SlidingBoxes hand;
  for (int i = 0; i < 3; ++i) hand.add(cube, 0.1 * i);
  const SelfCollision collision(hand.profile, hand.geometry);
  const std::vector<double> poses{0, 0.1,  0.25,   // free, 80 mm
                                  0, 0.01, 0.2,    // 0 and 1
                                  0, 0.1,  0.11,   // 1 and 2
                                  0, 0.01, 0.015,  // all
                                  0, 0.05, 0.2,    // free, 30 mm
                                  0, 0.1,  0.09};  // 1 and 2
  for (const int threads : {1, 2, 5}) {
    CAPTURE(threads);
    const BatteryCollisions battery = battery_collisions(collision, poses, threads);
    REQUIRE(battery.nearest.size() == 6);
    CHECK(battery.colliding == 4);
    CHECK(std::abs(battery.nearest[0].distance - 0.08) < 1e-12);
    CHECK(std::abs(battery.nearest[4].distance - 0.03) < 1e-12);
    CHECK(battery.nearest[4].first == 0);
    CHECK(battery.nearest[4].second == 1);
    for (const int i : {1, 2, 3, 5}) {
      CHECK(battery.nearest[i].colliding);
      CHECK(battery.nearest[i].distance == 0);
    }
    REQUIRE(battery.pairs.size() == 3);
    const PairContacts expected[] = {{1, 2, 3}, {0, 1, 2}, {0, 2, 1}};
    for (int k = 0; k < 3; ++k) {
      CHECK(battery.pairs[k].first == expected[k].first);
      CHECK(battery.pairs[k].second == expected[k].second);
      CHECK(battery.pairs[k].poses == expected[k].poses);
    }
  }
}
