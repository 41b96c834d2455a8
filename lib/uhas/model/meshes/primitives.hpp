// URDF primitives as triangles: closed, normals outward, vertices on the surface, centred at the origin of their frame.
// Sizes are in metres and positive.
#pragma once

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// @param size  edge lengths along x, y, z
TriangleMesh tessellate_box(Vector3d size);

/// A cylinder about z.
TriangleMesh tessellate_cylinder(double radius, double length);

TriangleMesh tessellate_sphere(double radius);

/// A cylinder about z that ends in two half spheres.
/// @param length  of the part between the half spheres
TriangleMesh tessellate_capsule(double radius, double length);

}  // namespace uhas
