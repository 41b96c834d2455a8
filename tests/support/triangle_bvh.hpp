// Rays against triangles in double, independent of Embree: an oracle for what a ray meets first.
#pragma once

#include <array>
#include <vector>

#include "uhas/base/vector3.hpp"

namespace uhas::test {

using Corners = std::array<Vector3d, 3>;

/// Distance, in lengths of `direction`, at which the ray meets the triangle, either side; infinity when it misses
/// (Moeller and Trumbore, 1997).
double ray_distance(const Corners& triangle, Vector3d origin, Vector3d direction);

/// A bounding-volume hierarchy, split at the median of the longest side.
class TriangleBvh {
 public:
  explicit TriangleBvh(std::vector<Corners> triangles);

  /// The least `ray_distance` over all triangles; `limit` when none is less.
  double first_hit(Vector3d origin, Vector3d direction, double limit) const;

 private:
  struct Node {
    Vector3d lower, upper;
    int begin = 0, end = 0;  ///< triangles
    int right = -1;          ///< the second child, the first one follows the node; -1 = a leaf
  };
  int build(int begin, int end);
  void search(int node, Vector3d origin, Vector3d direction, double& nearest) const;

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace uhas::test
