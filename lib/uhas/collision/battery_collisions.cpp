#include "uhas/collision/battery_collisions.hpp"

#include <algorithm>
#include <thread>

namespace uhas {

BatteryCollisions battery_collisions(const SelfCollision& collision, std::span<const double> poses, int threads) {
  const std::size_t joints = static_cast<std::size_t>(collision.joint_count()), count = poses.size() / joints;
  BatteryCollisions result;
  result.nearest.resize(count);
  std::vector<std::vector<int>> contacts(count);  // [pose]
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += static_cast<std::size_t>(threads)) {
      const std::span<const double> q = poses.subspan(i * joints, joints);
      result.nearest[i] = collision.nearest(q);
      if (result.nearest[i].colliding) contacts[i] = collision.colliding_pairs(q);
    }
  };
  {
    std::vector<std::jthread> others;
    for (int thread = 1; thread < threads; ++thread) others.emplace_back(work, static_cast<std::size_t>(thread));
    work(0);
  }

  std::vector<std::size_t> poses_of(collision.pairs().size());
  for (const std::vector<int>& pairs : contacts) {
    result.colliding += !pairs.empty();
    for (const int pair : pairs) ++poses_of[pair];
  }
  for (std::size_t k = 0; k < poses_of.size(); ++k)
    if (poses_of[k] > 0) result.pairs.push_back({collision.pairs()[k].first, collision.pairs()[k].second, poses_of[k]});
  std::ranges::stable_sort(result.pairs, std::ranges::greater(), &PairContacts::poses);
  return result;
}

}  // namespace uhas
