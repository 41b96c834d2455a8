// The bound on the triangles of a hand, which bounds its vertices too.
#pragma once

#include <cstdint>
#include <string>

namespace uhas {

/// Refuses more than `max_triangles` triangles, and more vertices than these have corners or an index can name. Without
/// the second, a file of few triangles and very many vertices would take any memory.
/// @param subject  begins the error: "the mesh has", "the meshes have"
/// Throws Error(limit_exceeded) in the name of `file`.
void require_within_bounds(std::uint64_t triangles, std::uint64_t vertices, std::uint64_t max_triangles,
                           const char* subject, const std::string& file);

}  // namespace uhas
