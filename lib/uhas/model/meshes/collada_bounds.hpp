// Bounds on what a Collada file (.dae) claims, checked before assimp believes it.
#pragma once

#include <string>
#include <string_view>

namespace uhas {

/// assimp 5.2.5 reads a list of indices that holds anything else without end, and makes room for as many elements as a
/// `count` says; this refuses both. `text` is the whole file. Throws Error: invalid_mesh, limit_exceeded, syntax; all
/// name `file` and the line.
void check_collada_bounds(std::string_view text, const std::string& file);

}  // namespace uhas
