#include "uhas/kinematics/finger_groups.hpp"

#include <algorithm>

namespace uhas {

std::vector<std::vector<int>> group_fingers(std::span<const std::vector<int>> unknowns) {
  const auto shares = [&](int a, int b) {
    return std::ranges::any_of(unknowns[a],
                               [&](int u) { return std::ranges::find(unknowns[b], u) != unknowns[b].end(); });
  };
  std::vector<std::vector<int>> groups;
  for (int f = 0; f < static_cast<int>(unknowns.size()); ++f) {
    // the groups so far that the finger shares nothing with stay; it joins the others to one
    const auto joined = std::stable_partition(groups.begin(), groups.end(), [&](const std::vector<int>& group) {
      return std::ranges::none_of(group, [&](int other) { return shares(f, other); });
    });
    std::vector<int> group{f};
    for (auto other = joined; other != groups.end(); ++other) group.insert(group.end(), other->begin(), other->end());
    groups.erase(joined, groups.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace uhas
