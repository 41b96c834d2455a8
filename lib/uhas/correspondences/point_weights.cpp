#include "uhas/correspondences/point_weights.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace uhas {
namespace {

double squared_distance(Vector3d a, Vector3d b) { return dot(a - b, a - b); }

std::size_t nearest_to_mean(std::span<const Correspondence> points) {
  Vector3d sum;
  for (const Correspondence& point : points) sum += point.p_link;
  const Vector3d mean = sum / static_cast<double>(points.size());
  const auto nearest = std::ranges::min_element(
      points, {}, [&](const Correspondence& point) { return squared_distance(point.p_link, mean); });
  return static_cast<std::size_t>(nearest - points.begin());
}

/// Counts, as weights, how many of one link's points are nearest to each chosen one.
void weigh_link(std::span<Correspondence> points, int max_chosen) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> gap(points.size(), infinity);  // squared, to the nearest chosen point
  std::vector<std::size_t> nearest(points.size());   // that chosen point

  // farthest-point sampling: the next one is the point with the widest gap
  std::size_t chosen = nearest_to_mean(points);
  for (int count = 0; count < max_chosen && gap[chosen] > 0; ++count) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance = squared_distance(points[i].p_link, points[chosen].p_link);
      if (distance < gap[i]) {
        gap[i] = distance;
        nearest[i] = chosen;
      }
    }
    chosen = static_cast<std::size_t>(std::ranges::max_element(gap) - gap.begin());
  }

  // a point stands for those that are nearest to it
  for (const std::size_t i : nearest) points[i].weight += 1;
}

}  // namespace

void assign_point_weights(std::span<Correspondence> points, std::span<const ProfileLink> links, int points_per_link) {
  // link by link: points come sorted
  double total = 0;
  for (auto begin = points.begin(); begin != points.end();) {
    const int link = begin->link;
    const auto end =
        std::find_if(begin, points.end(), [link](const Correspondence& point) { return point.link != link; });
    const std::span<Correspondence> of_link(begin, end);
    for (Correspondence& point : of_link) point.weight = 0;
    if (links[link].joint >= 0) {
      weigh_link(of_link, points_per_link);
      total += static_cast<double>(of_link.size());
    }
    begin = end;
  }

  // shares of the hand
  if (total > 0)
    for (Correspondence& point : points) point.weight /= total;
}

}  // namespace uhas
