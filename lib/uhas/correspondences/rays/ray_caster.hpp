// The nearest triangle along a ray. The only room of the project that knows Embree, and its only owner.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// A mesh and where it stands.
struct PosedMesh {
  const TriangleMesh* mesh = nullptr;
  RigidTransformd T_world_mesh;
};

/// A triangle of one of the meshes. Only its name: Embree computes in float and with the vector width of the machine,
/// so whoever needs the point where the ray meets the triangle computes it from the mesh.
struct TriangleHit {
  std::uint32_t mesh = 0;      ///< index into the meshes the caster was made of
  std::uint32_t triangle = 0;  ///< index into TriangleMesh::triangles
};

/// Immutable once made; `first_hit` may be called from any number of threads.
class RayCaster {
 public:
  /// Copies the meshes; an empty one is never hit.
  /// Throws Error(invalid_mesh) when Embree refuses them, for example for want of memory.
  explicit RayCaster(std::span<const PosedMesh> meshes);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// The triangle that a ray from `origin` meets first, either side of it; nothing when the ray leaves the scene.
  std::optional<TriangleHit> first_hit(Vector3d origin, Vector3d direction) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace uhas
