#include "support/mesh_contact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace uhas::test {
namespace {

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y), std::min(a.lower.z, b.lower.z)},
          {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y), std::max(a.upper.z, b.upper.z)}};
}

Box box_of(const Corners& t) { return joined({t[0], t[0]}, joined({t[1], t[1]}, {t[2], t[2]})); }

/// Whether the boxes come within `reach` of each other along each axis.
bool within(const Box& a, const Box& b, double reach) {
  return a.lower.x <= b.upper.x + reach && b.lower.x <= a.upper.x + reach && a.lower.y <= b.upper.y + reach &&
         b.lower.y <= a.upper.y + reach && a.lower.z <= b.upper.z + reach && b.lower.z <= a.upper.z + reach;
}

/// Of the point `p` from the segment from `a` to `b`.
double segment_distance(Vector3d p, Vector3d a, Vector3d b) {
  const Vector3d ab = b - a;
  const double t = dot(ab, ab) > 0 ? std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0) : 0;
  return norm(p - (a + t * ab));
}

/// Of a point from a triangle: from its plane where it projects inside, else from the nearest edge.
double point_distance(Vector3d p, const Corners& t) {
  const Vector3d n = cross(t[1] - t[0], t[2] - t[0]);
  bool inside = norm(n) > 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d a = t[i], b = t[(i + 1) % 3];
    inside = inside && dot(cross(b - a, p - a), n) >= 0;
    least = std::min(least, segment_distance(p, a, b));
  }
  return inside ? std::abs(dot(p - t[0], n)) / norm(n) : least;
}

/// Of two segments: where their lines come nearest if that is within both, else of an end.
double segments_distance(Vector3d a0, Vector3d a1, Vector3d b0, Vector3d b1) {
  const Vector3d u = a1 - a0, v = b1 - b0, w = b0 - a0, n = cross(u, v);
  double least = std::min({segment_distance(a0, b0, b1), segment_distance(a1, b0, b1), segment_distance(b0, a0, a1),
                           segment_distance(b1, a0, a1)});
  const double nn = dot(n, n);
  if (nn > 0) {
    const double s = dot(cross(w, v), n) / nn, t = dot(cross(w, u), n) / nn;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, std::abs(dot(w, n)) / std::sqrt(nn));
  }
  return least;
}

/// Whether the segment from `a` to `b` meets the triangle: its ends lie on either side of the plane, and its line
/// passes all three edges on one side.
bool crosses(Vector3d a, Vector3d b, const Corners& t) {
  const auto volume = [](Vector3d p, Vector3d q, Vector3d r, Vector3d s) { return dot(cross(q - p, r - p), s - p); };
  const double side_a = volume(t[0], t[1], t[2], a), side_b = volume(t[0], t[1], t[2], b);
  if (side_a * side_b > 0 || side_a == side_b) return false;
  const double e0 = volume(a, b, t[0], t[1]), e1 = volume(a, b, t[1], t[2]), e2 = volume(a, b, t[2], t[0]);
  return (e0 >= 0 && e1 >= 0 && e2 >= 0) || (e0 <= 0 && e1 <= 0 && e2 <= 0);
}

bool triangles_cross(const Corners& a, const Corners& b) {
  for (int i = 0; i < 3; ++i)
    if (crosses(a[i], a[(i + 1) % 3], b) || crosses(b[i], b[(i + 1) % 3], a)) return true;
  return false;
}

/// Those of `mesh` that come within `reach` of `box`, by their least x.
std::vector<BoxedTriangle> near_to(const PlacedMesh& mesh, const Box& box, double reach) {
  std::vector<BoxedTriangle> result;
  std::ranges::copy_if(mesh.triangles, std::back_inserter(result),
                       [&](const auto& t) { return within(t.box, box, reach); });
  std::ranges::sort(result, {}, [](const auto& t) { return t.box.lower.x; });
  return result;
}

/// Calls `visit(s, t)` for triangles of `a` and `b` whose boxes come within `reach` of each other; it
/// may lessen `reach`.
template <class Visit>
void for_near_pairs(const PlacedMesh& a, const PlacedMesh& b, double& reach, const Visit& visit) {
  if (!within(a.box, b.box, reach)) return;
  const std::vector<BoxedTriangle> near_a = near_to(a, b.box, reach), near_b = near_to(b, a.box, reach);
  double widest = 0;  // of b, along x
  for (const BoxedTriangle& t : near_b) widest = std::max(widest, t.box.upper.x - t.box.lower.x);
  for (const BoxedTriangle& s : near_a) {
    auto t = std::ranges::lower_bound(near_b, s.box.lower.x - widest - reach, {},
                                      [](const auto& e) { return e.box.lower.x; });
    for (; t != near_b.end() && t->box.lower.x <= s.box.upper.x + reach; ++t)
      if (within(s.box, t->box, reach)) visit(s.corners, t->corners);
  }
}

}  // namespace

PlacedMesh::PlacedMesh(const TriangleMesh& mesh, const RigidTransformd& T) {
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Corners corners{T * mesh.vertices[a], T * mesh.vertices[b], T * mesh.vertices[c]};
    triangles.push_back({corners, box_of(corners)});
    box = triangles.size() == 1 ? triangles.front().box : joined(box, triangles.back().box);
  }
}

double triangle_distance(const Corners& a, const Corners& b) {
  if (triangles_cross(a, b)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    least = std::min({least, point_distance(a[i], b), point_distance(b[i], a)});
    for (int j = 0; j < 3; ++j) least = std::min(least, segments_distance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
  }
  return least;
}

double mesh_distance(const PlacedMesh& a, const PlacedMesh& b, double limit) {
  for_near_pairs(a, b, limit,
                 [&](const Corners& s, const Corners& t) { limit = std::min(limit, triangle_distance(s, t)); });
  return limit;
}

bool meshes_cross(const PlacedMesh& a, const PlacedMesh& b) {
  double reach = 0;
  bool cross = false;
  for_near_pairs(a, b, reach, [&](const Corners& s, const Corners& t) { cross = cross || triangles_cross(s, t); });
  return cross;
}

bool is_inside(Vector3d p, const PlacedMesh& mesh) {
  const Vector3d direction{0.5391, 0.3877, 0.7477};  // along no edge of a box
  const auto is_met = [&](const BoxedTriangle& t) { return std::isfinite(ray_distance(t.corners, p, direction)); };
  return std::ranges::count_if(mesh.triangles, is_met) % 2 == 1;
}

}  // namespace uhas::test
