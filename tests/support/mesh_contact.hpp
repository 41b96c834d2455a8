// Distance and contact of meshes triangle by triangle, independent of FCL.
#pragma once

#include <vector>

#include "support/triangle_bvh.hpp"
#include "uhas/base/rigid_transform.hpp"
#include "uhas/model/hand_model.hpp"

namespace uhas::test {

/// Least and greatest coordinates.
struct Box {
  Vector3d lower, upper;
};

struct BoxedTriangle {
  Corners corners;
  Box box;
};

/// A mesh moved by `T`. It has triangles.
struct PlacedMesh {
  PlacedMesh(const TriangleMesh& mesh, const RigidTransformd& T);

  std::vector<BoxedTriangle> triangles;
  Box box;
};

/// Least distance of two triangles; 0 when an edge of one crosses the other.
double triangle_distance(const Corners& a, const Corners& b);

/// Least distance over all pairs of triangles, or `limit` when none is less.
double mesh_distance(const PlacedMesh& a, const PlacedMesh& b, double limit);

/// Whether an edge of a triangle of one crosses a triangle of the other.
bool meshes_cross(const PlacedMesh& a, const PlacedMesh& b);

/// Whether `p` is inside a closed mesh: a ray from it meets the triangles an odd number of times.
bool is_inside(Vector3d p, const PlacedMesh& mesh);

}  // namespace uhas::test
