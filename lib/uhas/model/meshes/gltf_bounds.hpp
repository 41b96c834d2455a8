// Bounds on what a glTF file claims, checked before assimp believes it.
#pragma once

#include <filesystem>
#include <string_view>

namespace uhas {

/// A few kilobytes of glTF can claim gigabytes: accessors need no bytes behind them, and primitives may share one. This
/// refuses a file whose primitives use many more elements than it has bytes, whose JSON is nested beyond any real one,
/// or whose nodes form no trees: a node that several others share would be copied for each way that leads to it.
/// @param bytes  the content of the .glb or .gltf file
/// @param path   names the file in errors, and the folder of its buffers
/// Throws Error: invalid_mesh (no glTF, no trees), limit_exceeded.
void check_gltf_bounds(std::string_view bytes, const std::filesystem::path& path);

}  // namespace uhas
