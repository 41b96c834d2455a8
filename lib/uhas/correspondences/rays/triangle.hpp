// Geometry of mesh triangles in double: what a ray meets, and which way a mesh faces.
#pragma once

#include <array>
#include <cstdint>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// Three corners; the front is the side from which they run counter-clockwise.
using Triangle = std::array<Vector3d, 3>;

Triangle mesh_triangle(const TriangleMesh& mesh, std::uint32_t triangle);

/// Normal of the front; its length is twice the area.
Vector3d area_normal(const Triangle& triangle);

/// The point with weights `barycentric` of the three corners.
Vector3d point_at(const Triangle& triangle, Vector3d barycentric);

/// Where a ray meets a triangle.
struct RayMeeting {
  double facing = 0;     ///< direction . area normal: negative when the ray meets the front
  Vector3d barycentric;  ///< weights of the corners, each in [0, 1], sum 1; meaningless when `facing` is 0
};

/// The ray from the origin along `direction` and a triangle that it is known to meet, if for a rounding error:
/// a meeting beyond an edge is moved onto the triangle.
RayMeeting meet_from_origin(const Triangle& triangle, Vector3d direction);

/// True when the mesh encloses a negative volume: all its triangles show their back to the outside. An open mesh is
/// judged from its centroid; one that encloses next to nothing, such as a plate, is taken at its word (false).
bool is_inside_out(const TriangleMesh& mesh);

}  // namespace uhas
