// The volume that a mesh encloses, for what the triangles of two meshes do not show: one wholly inside the other.
#pragma once

#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// One corner of each connected piece of the mesh (m, in its frame). Corners at one place are one.
std::vector<Vector3d> one_corner_a_piece(const TriangleMesh& mesh);

/// How often the mesh winds about `p`: 1 inside a closed mesh, 0 outside, -1 inside one whose triangles face inward, in between
/// for a mesh with holes (the sum of solid angles: Jacobson et al., "Robust inside-outside segmentation using generalized winding
/// numbers", 2013).
double winding_number(const TriangleMesh& mesh, Vector3d p);

}  // namespace uhas
