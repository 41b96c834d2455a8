#include "uhas/model/meshes/primitives.hpp"

#include <cmath>
#include <numbers>
#include <span>

namespace uhas {
namespace {

// The chord of 32 segments is 0.5 % of the radius inside the circle.
constexpr int segments = 32;
constexpr int rings_of_half_sphere = 8;

struct ProfilePoint {
  double radius, z;
};

/// Turns a profile about z. It runs from the bottom pole to the top pole, and both have radius 0.
TriangleMesh revolve(std::span<const ProfilePoint> profile) {
  TriangleMesh mesh;
  const auto inner = profile.subspan(1, profile.size() - 2);
  for (const ProfilePoint& point : inner)
    for (int s = 0; s < segments; ++s) {
      const double azimuth = 2 * std::numbers::pi * s / segments;
      mesh.vertices.push_back({point.radius * std::cos(azimuth), point.radius * std::sin(azimuth), point.z});
    }
  const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({0, 0, profile.front().z});
  mesh.vertices.push_back({0, 0, profile.back().z});

  const auto vertex = [](std::size_t ring, int s) {
    return static_cast<std::uint32_t>(ring * segments + s % segments);
  };
  for (int s = 0; s < segments; ++s) {
    mesh.triangles.push_back({bottom, vertex(0, s + 1), vertex(0, s)});
    for (std::size_t ring = 0; ring + 1 < inner.size(); ++ring) {
      mesh.triangles.push_back({vertex(ring, s), vertex(ring, s + 1), vertex(ring + 1, s + 1)});
      mesh.triangles.push_back({vertex(ring, s), vertex(ring + 1, s + 1), vertex(ring + 1, s)});
    }
    mesh.triangles.push_back({bottom + 1, vertex(inner.size() - 1, s), vertex(inner.size() - 1, s + 1)});
  }
  return mesh;
}

/// A sphere cut at its equator, the halves `length` apart.
TriangleMesh revolve_half_spheres(double radius, double length) {
  std::vector<ProfilePoint> profile;
  for (const double end : {-0.5, 0.5})
    for (int ring = 0; ring <= rings_of_half_sphere; ++ring) {
      const double quarter = std::numbers::pi / 2 * ring / rings_of_half_sphere;
      const double latitude = end < 0 ? quarter - std::numbers::pi / 2 : quarter;
      if (length == 0 && end > 0 && ring == 0) continue;  // one equator, not two
      profile.push_back({radius * std::cos(latitude), end * length + radius * std::sin(latitude)});
    }
  return revolve(profile);
}

}  // namespace

TriangleMesh tessellate_box(Vector3d size) {
  TriangleMesh mesh;
  for (const double z : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double x : {-0.5, 0.5}) mesh.vertices.push_back({x * size.x, y * size.y, z * size.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh tessellate_cylinder(double radius, double length) {
  const double half = length / 2;
  const ProfilePoint profile[] = {{0, -half}, {radius, -half}, {radius, half}, {0, half}};
  return revolve(profile);
}

TriangleMesh tessellate_sphere(double radius) { return revolve_half_spheres(radius, 0); }

TriangleMesh tessellate_capsule(double radius, double length) { return revolve_half_spheres(radius, length); }

}  // namespace uhas
