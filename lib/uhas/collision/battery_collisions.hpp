// Self-collision over many poses of a hand.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "uhas/collision/self_collision.hpp"

namespace uhas {

/// How often two links touch.
struct PairContacts {
  int first = -1, second = -1;  ///< indices into `HandProfile::links`, first < second
  std::size_t poses = 0;        ///< in which they are in contact, at least 1
};

struct BatteryCollisions {
  std::vector<NearestLinks> nearest;  ///< one a pose
  std::vector<PairContacts> pairs;    ///< those in contact in some pose, most poses first, then by links
  std::size_t colliding = 0;          ///< poses in self-collision
};

/// `poses`: [N x joints of the hand] row after row. The same result for any number of threads, at least 1.
BatteryCollisions battery_collisions(const SelfCollision& collision, std::span<const double> poses, int threads = 1);

}  // namespace uhas
