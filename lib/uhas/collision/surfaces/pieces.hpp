// The volume that a mesh encloses, for what the triangles of two meshes do not show: one wholly inside the other.
#pragma once

#include <array>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// The corners of a connected piece of a mesh that lie farthest out along x, y and z, least and greatest (m, frame
/// of the mesh).
using PieceExtremes = std::array<Vector3d, 6>;

/// One element a piece. Corners at one place are one.
std::vector<PieceExtremes> find_pieces(const TriangleMesh& mesh);

/// How often the mesh winds about `p`: 1 inside a closed mesh, 0 outside, -1 inside one whose triangles face inward, in
/// between for a mesh with holes (the sum of solid angles: Jacobson et al., "Robust inside-outside segmentation using
/// generalized winding numbers", 2013).
double winding_number(const TriangleMesh& mesh, Vector3d p);

}  // namespace uhas
