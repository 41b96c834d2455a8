#include "support/triangle_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace uhas::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kLeafSize = 4;

Vector3d lower_of(Vector3d a, Vector3d b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vector3d upper_of(Vector3d a, Vector3d b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// Distance at which the ray enters the box; infinity when it misses. A ray inside a face's plane gives 0 * infinity =
/// NaN, which min and max here take as no bound.
double box_distance(Vector3d lower, Vector3d upper, Vector3d origin, Vector3d direction) {
  double enter = 0, leave = kInfinity;
  for (double Vector3d::*axis : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
    const double inverse = 1 / direction.*axis;
    const double a = (lower.*axis - origin.*axis) * inverse, b = (upper.*axis - origin.*axis) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  constexpr double rounding = 1 + 1e-12;
  return enter <= leave * rounding ? enter : kInfinity;
}

}  // namespace

double ray_distance(const Corners& triangle, Vector3d origin, Vector3d direction) {
  const Vector3d edge1 = triangle[1] - triangle[0], edge2 = triangle[2] - triangle[0];
  const Vector3d p = cross(direction, edge2);
  const double determinant = dot(edge1, p);
  if (determinant == 0) return kInfinity;
  const Vector3d from_corner = origin - triangle[0];
  const double u = dot(from_corner, p) / determinant;
  const Vector3d q = cross(from_corner, edge1);
  const double v = dot(direction, q) / determinant;
  const double t = dot(edge2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 ? t : kInfinity;
}

TriangleBvh::TriangleBvh(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
  nodes_.reserve(triangles_.size());
  build(0, static_cast<int>(triangles_.size()));
}

int TriangleBvh::build(int begin, int end) {
  const int index = static_cast<int>(nodes_.size());
  Node node{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}, begin, end};
  for (int i = begin; i < end; ++i)
    for (const Vector3d corner : triangles_[i]) {
      node.lower = lower_of(node.lower, corner);
      node.upper = upper_of(node.upper, corner);
    }
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) return index;

  const Vector3d size = node.upper - node.lower;
  double Vector3d::*axis = &Vector3d::x;
  if (size.y > size.*axis) axis = &Vector3d::y;
  if (size.z > size.*axis) axis = &Vector3d::z;
  const int middle = (begin + end) / 2;
  const auto first = triangles_.begin();
  std::nth_element(first + begin, first + middle, first + end, [axis](const Corners& a, const Corners& b) {
    return (a[0] + a[1] + a[2]).*axis < (b[0] + b[1] + b[2]).*axis;
  });
  build(begin, middle);
  nodes_[index].right = build(middle, end);
  return index;
}

double TriangleBvh::first_hit(Vector3d origin, Vector3d direction, double limit) const {
  search(0, origin, direction, limit);
  return limit;
}

void TriangleBvh::search(int index, Vector3d origin, Vector3d direction, double& nearest) const {
  const Node& node = nodes_[index];
  if (!(box_distance(node.lower, node.upper, origin, direction) < nearest)) return;
  if (node.right < 0) {
    for (int i = node.begin; i < node.end; ++i)
      nearest = std::min(nearest, ray_distance(triangles_[i], origin, direction));
    return;
  }
  search(index + 1, origin, direction, nearest);
  search(node.right, origin, direction, nearest);
}

}  // namespace uhas::test
