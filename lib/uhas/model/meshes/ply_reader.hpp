// PLY files, read here because assimp 5.2 crashes on most damaged binary ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// Reads ASCII and binary PLY of either byte order: x, y, z of element `vertex` and vertex_indices (or vertex_index) of
/// element `face`; faces with more than three corners are cut into a fan, everything else is skipped.
/// @param file  names the file in errors
/// Throws Error: invalid_mesh; limit_exceeded (see `require_within_bounds`).
TriangleMesh read_ply(std::span<const std::byte> bytes, const std::string& file, std::uint64_t max_triangles);

}  // namespace uhas
