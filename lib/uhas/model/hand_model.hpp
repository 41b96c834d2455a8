// The hand model: a URDF and its meshes as plain data. Metres and radians; meshes are in the frame of their link.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "uhas/base/kinematic_tree.hpp"
#include "uhas/model/model_load_options.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Triangles in the frame of the link they belong to (m), counter-clockwise seen from outside. No degenerate triangle,
/// every index in range, every vertex finite and used.
struct TriangleMesh {
  std::vector<Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A link of the URDF.
struct ModelLink {
  std::string name;
  int parent_link = -1;  ///< index into `HandModel::links`, below its own; -1 = this is the root link
  int joint = -1;        ///< index into `HandModel::tree` of the movable joint that carries it; -1 = fixed to the root
  RigidTransformd T_joint_link;  ///< link frame in that joint's moved frame (in the root link's frame for -1)
  TriangleMesh mesh;             ///< all geometry of the link, merged; empty when it has none
};

/// A URDF, read and checked. Links are ordered depth first, siblings by name, so that every parent precedes its
/// children and the order of elements in the file does not matter; joints follow the order of their child links.
struct HandModel {
  std::string name;
  std::vector<ModelLink> links;           ///< links[0] is the root
  KinematicTree tree;                     ///< movable joints; root frame = the root link's frame
  std::vector<SourceFile> sources;        ///< the URDF first, then each mesh file once, in order of use
  std::vector<std::string> source_paths;  ///< where each of `sources` was found
  std::vector<std::string> warnings;      ///< things a user should know, each a sentence
};

/// Reads a URDF and every mesh it names: STL, OBJ, DAE, PLY, GLB and glTF, and the primitives box, cylinder, sphere and
/// capsule. Prints nothing; what a user should know is in `HandModel::warnings`.
/// Throws Error: file_unreadable, syntax, invalid_model, invalid_mesh, limit_exceeded.
HandModel load_hand_model(const std::string& urdf_path, const ModelLoadOptions& options = {});

/// The bytes of the URDF alone, within its bound. Throws Error: file_unreadable, limit_exceeded.
std::vector<std::byte> read_urdf_file(const std::string& urdf_path, const ModelLoadOptions& options);

}  // namespace uhas
