#include "uhas/geometry/simplified_geometry.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace uhas {
namespace {

constexpr double kFirstDistance = 2e-5,
                 kLastDistance = 5e-2;  // m: from below what a picture shows to a whole finger link
constexpr double kDistanceStep = 1.5;

/// A mesh as meshoptimizer takes it, vertices at one place made one.
struct WeldedMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<unsigned> indices;  // three a triangle

  const float* positions() const { return vertices.empty() ? nullptr : vertices.front().data(); }
};

constexpr std::size_t kStride = sizeof(std::array<float, 3>);

/// Without the triangles that `indices` has lost corners of, and without the vertices that are then unused.
WeldedMesh compacted(std::span<const std::array<float, 3>> vertices, std::span<const unsigned> indices) {
  constexpr unsigned unused = std::numeric_limits<unsigned>::max();
  WeldedMesh result;
  std::vector<unsigned> index_of(vertices.size(), unused);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const unsigned a = indices[i], b = indices[i + 1], c = indices[i + 2];
    if (a == b || b == c || c == a) continue;
    for (const unsigned corner : {a, b, c}) {
      if (index_of[corner] == unused) {
        index_of[corner] = static_cast<unsigned>(result.vertices.size());
        result.vertices.push_back(vertices[corner]);
      }
      result.indices.push_back(index_of[corner]);
    }
  }
  return result;
}

WeldedMesh weld(const TriangleMesh& mesh) {
  std::vector<std::array<float, 3>> vertices;
  for (const Vector3d& p : mesh.vertices)
    vertices.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  std::vector<unsigned> indices;
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());

  std::vector<unsigned> place_of(vertices.size());
  meshopt_generateVertexRemap(place_of.data(), indices.data(), indices.size(), vertices.data(), vertices.size(),
                              kStride);
  std::vector<std::array<float, 3>> places(vertices.size());
  meshopt_remapVertexBuffer(places.data(), vertices.data(), vertices.size(), kStride, place_of.data());
  for (unsigned& index : indices) index = place_of[index];
  return compacted(places, indices);
}

/// Within `distance` (m) of the surface of `mesh`.
WeldedMesh simplified(const WeldedMesh& mesh, double distance) {
  if (mesh.indices.empty()) return mesh;
  const float scale = meshopt_simplifyScale(mesh.positions(), mesh.vertices.size(), kStride);
  if (!(scale > 0)) return mesh;
  std::vector<unsigned> kept(mesh.indices.size());
  kept.resize(meshopt_simplify(kept.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions(),
                               mesh.vertices.size(), kStride, 0, static_cast<float>(distance) / scale, 0, nullptr));
  return compacted(mesh.vertices, kept);
}

TriangleMesh triangle_mesh(const WeldedMesh& mesh) {
  TriangleMesh result;
  for (const auto& p : mesh.vertices) result.vertices.push_back({p[0], p[1], p[2]});
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    result.triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  return result;
}

std::size_t triangle_count(std::span<const WeldedMesh> meshes) {
  std::size_t count = 0;
  for (const WeldedMesh& mesh : meshes) count += mesh.indices.size() / 3;
  return count;
}

}  // namespace

HandGeometry simplified_geometry(const HandGeometry& geometry, std::size_t max_triangles) {
  std::vector<WeldedMesh> links;
  for (const TriangleMesh& mesh : geometry.links) links.push_back(weld(mesh));
  for (double distance = kFirstDistance; triangle_count(links) > max_triangles && distance < kLastDistance;
       distance *= kDistanceStep)
    for (WeldedMesh& mesh : links) mesh = simplified(mesh, distance);

  HandGeometry result;
  for (const WeldedMesh& mesh : links) result.links.push_back(triangle_mesh(mesh));
  return result;
}

}  // namespace uhas
