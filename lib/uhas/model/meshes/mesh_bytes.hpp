// A mesh that was read, and the log of files read so far, as the bytes that a child process hands over.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"
#include "uhas/model/meshes/source_file.hpp"

namespace uhas {

struct ReadMesh {
  TriangleMesh mesh;
  std::vector<LoggedFile> sources;
};

std::vector<std::byte> to_bytes(const ReadMesh& read);

/// The inverse. Throws Error(invalid_mesh) in the name of `file` for bytes that are no mesh.
ReadMesh read_mesh_from_bytes(std::span<const std::byte> bytes, const std::string& file);

}  // namespace uhas
