// Mesh files as plain triangles.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"
#include "uhas/model/meshes/mesh_folders.hpp"
#include "uhas/model/meshes/source_file.hpp"

namespace uhas {

/// A mesh file and how the URDF names it.
struct MeshFile {
  std::filesystem::path path;
  std::string reference;
};

/// Reads STL (binary, ASCII), OBJ, DAE, PLY, GLB or glTF, chosen by the extension, into the file's own frame and units
/// (a DAE's <unit> is applied), the transforms of its nodes included; one mesh for each of `files`.
///
/// The up axis of a DAE is NOT applied. URDF says that a mesh's coordinates are those of its frame, and rviz, MoveIt
/// and the exporters of hands agree: a DAE marked Z_UP and one marked Y_UP with the same numbers are the same mesh.
/// glTF is always Y up by its specification; there, too, the numbers are taken as they are, for exporters that write
/// meshes for URDF store them in the link frame.
///
/// Every file read is added to `sources`. Faces that are not triangles after triangulation (lines, points) are skipped.
/// @param folders  where the buffers of a glTF file may be; where the files themselves may be is for the caller to ask
/// Throws Error: file_unreadable, limit_exceeded, invalid_mesh.
std::vector<TriangleMesh> read_meshes(std::span<const MeshFile> files, const ModelLoadOptions& options,
                                      const MeshFolders& folders, SourceLog& sources);

}  // namespace uhas
