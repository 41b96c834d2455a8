// Where the mesh file is that a URDF names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// The folders of the environment variable ROS_PACKAGE_PATH, in order.
std::vector<std::filesystem::path> ros_package_path();

/// Finds the file behind `reference`: a path relative to `urdf_folder`, an absolute path, file://PATH, or
/// package://NAME/PATH. A package is looked for in `packages`, then in the folders of the environment variable
/// ROS_PACKAGE_PATH, then as a folder NAME in `urdf_folder` or any folder above it.
/// @param urdf_file  names the URDF in errors
/// Throws Error(file_unreadable) for a package that is not found and for schemes that would need a network.
std::filesystem::path find_mesh(const std::string& reference, const std::filesystem::path& urdf_folder,
                                const std::vector<PackageFolder>& packages, const std::string& urdf_file);

}  // namespace uhas
