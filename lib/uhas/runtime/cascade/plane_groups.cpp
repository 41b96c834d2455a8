#include "uhas/runtime/cascade/plane_groups.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace uhas {
namespace {

constexpr double kPi = std::numbers::pi;

/// On the circle: the direction of the sum of unit vectors.
double mean_azimuth(const HandProfile& profile, const std::vector<int>& group) {
  double c = 0, s = 0;
  for (int f : group) c += std::cos(profile.fingers[f].theta_initial), s += std::sin(profile.fingers[f].theta_initial);
  return std::atan2(s, c);
}

}  // namespace

PlaneGroups group_planes(const HandProfile& profile) {
  // the fingers by azimuth
  constexpr double same_plane = 5 * kPi / 180;
  std::vector<int> order(profile.fingers.size());
  std::iota(order.begin(), order.end(), 0);
  const auto theta = [&](int f) { return profile.fingers[f].theta_initial; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return theta(a) < theta(b); });

  // one group as long as the next finger is close
  std::vector<std::vector<int>> groups;
  for (int f : order) {
    if (!groups.empty() && theta(f) - theta(groups.back().back()) < same_plane)
      groups.back().push_back(f);
    else
      groups.push_back({f});
  }
  // around the circle the last may be close to the first
  if (groups.size() > 1 && theta(groups.front().front()) + 2 * kPi - theta(groups.back().back()) < same_plane) {
    groups.front().insert(groups.front().end(), groups.back().begin(), groups.back().end());
    groups.pop_back();
  }

  std::vector<double> azimuths;
  std::vector<int> of_finger(profile.fingers.size());
  for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
    azimuths.push_back(mean_azimuth(profile, groups[g]));
    for (int f : groups[g]) of_finger[f] = g;
  }
  return {groups, azimuths, of_finger};
}

BetweenPlanes locate_between_planes(double theta, const std::vector<double>& azimuths) {
  // the way around the circle, in [0, 2 pi)
  const auto way = [](double from, double to) {
    const double angle = std::fmod(to - from, 2 * kPi);
    return angle < 0 ? angle + 2 * kPi : angle;
  };
  // the nearest plane on either side
  int before = 0, after = 0;
  for (int g = 0; g < static_cast<int>(azimuths.size()); ++g) {
    if (way(azimuths[g], theta) < way(azimuths[before], theta)) before = g;
    if (way(theta, azimuths[g]) < way(theta, azimuths[after])) after = g;
  }
  const double gap = way(azimuths[before], theta) + way(theta, azimuths[after]);
  return {before, after, gap > 0 ? way(azimuths[before], theta) / gap : 0.0};
}

}  // namespace uhas
