// What of a URDF and its meshes is read, and how much of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "uhas/fence/child_limits.hpp"

namespace uhas {

/// Which shapes of a URDF's links are the hand's surface. Visual is the rule; use collision where the visuals are missing
/// or too detailed, both where neither is complete.
enum class GeometrySource : int { visual = 0, collision = 1, both = 2 };

/// A folder that `package://NAME/` stands for.
struct PackageFolder {
  std::string name, folder;
};

struct ModelLoadOptions {
  /// A link that lacks the wanted kind falls back to the other; `both` merges them.
  GeometrySource geometry = GeometrySource::visual;
  std::vector<PackageFolder> packages;  ///< searched before the folders of ROS_PACKAGE_PATH and those above the URDF
  bool load_meshes = true;              ///< false: skeleton only

  /// Meshes are read only below the folder of the model (the nearest one above the URDF with a package.xml, else the
  /// one that holds the URDF's folder), below `packages` and below the folders of ROS_PACKAGE_PATH, symbolic links
  /// followed; true: anywhere.
  bool allow_outside = false;

  /// For files that may bring a library down: mesh files are read in a child process under these limits, the URDF in
  /// one first and then here, and a crash is an Error. The tools do. Without limits everything is read in this process,
  /// which makes no copy of a program with threads.
  std::optional<ChildLimits> in_child;

  std::uint64_t max_urdf_bytes = 16u << 20;
  std::uint64_t max_links = 2000;             ///< a chain of 100,000 links overflows the stack of urdfdom
  std::uint64_t max_mesh_bytes = 512u << 20;  ///< of each file
  std::uint64_t max_triangles = 20'000'000;   ///< over the whole hand, which has at most three times as many vertices
};

}  // namespace uhas
