#include "uhas/correspondences/rays/triangle.hpp"

#include <algorithm>
#include <cmath>

namespace uhas {

Triangle mesh_triangle(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& corner = mesh.triangles[triangle];
  return {mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]]};
}

Vector3d area_normal(const Triangle& triangle) { return cross(triangle[1] - triangle[0], triangle[2] - triangle[0]); }

Vector3d point_at(const Triangle& triangle, Vector3d barycentric) {
  return barycentric.x * triangle[0] + barycentric.y * triangle[1] + barycentric.z * triangle[2];
}

RayMeeting meet_from_origin(const Triangle& triangle, Vector3d direction) {
  // A corner weighs as much as the volume that the direction spans with the opposite edge; the three volumes add up to
  // direction . area normal.
  const auto& [a, b, c] = triangle;
  const Vector3d volume{dot(direction, cross(b, c)), dot(direction, cross(c, a)), dot(direction, cross(a, b))};
  const double facing = volume.x + volume.y + volume.z;
  const Vector3d weight{std::max(0.0, volume.x / facing), std::max(0.0, volume.y / facing),
                        std::max(0.0, volume.z / facing)};
  return {facing, weight / (weight.x + weight.y + weight.z)};
}

bool is_inside_out(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return false;
  double volume = 0, area = 0;  // 6 x the volume over the origin, 2 x the area
  Vector3d normals, centroid;   // sum of area normals; 6 x the first moment of the area
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle triangle = mesh_triangle(mesh, i);
    const Vector3d normal = area_normal(triangle);
    const double triangle_area = norm(normal);
    volume += dot(triangle[0], normal);
    area += triangle_area;
    normals += normal;
    centroid += triangle_area * (triangle[0] + triangle[1] + triangle[2]);
  }
  // 100 x less than the thinnest solid among the links of real hands encloses for its surface
  constexpr double negligible = 1e-4;
  const double volume_from_centroid = volume - dot(centroid / (3 * area), normals);
  return volume_from_centroid < -negligible * std::pow(area, 1.5);
}

}  // namespace uhas
