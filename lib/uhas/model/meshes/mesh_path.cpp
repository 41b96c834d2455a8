#include "uhas/model/meshes/mesh_path.hpp"

#include <cstdlib>
#include <sstream>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

namespace fs = std::filesystem;

/// Folders that may be the package, best first.
std::vector<fs::path> package_candidates(const std::string& name, const fs::path& urdf_folder,
                                         const std::vector<PackageFolder>& packages) {
  std::vector<fs::path> candidates;
  for (const PackageFolder& package : packages)
    if (package.name == name) candidates.push_back(package.folder);

  const auto add_folder_and_content = [&](const fs::path& folder) {
    if (folder.filename() == name) candidates.push_back(folder);
    candidates.push_back(folder / name);
  };
  for (const fs::path& folder : ros_package_path()) add_folder_and_content(folder);
  for (fs::path folder = (fs::current_path() / urdf_folder).lexically_normal(); folder != folder.root_path();
       folder = folder.parent_path())
    add_folder_and_content(folder);
  return candidates;
}

}  // namespace

std::vector<fs::path> ros_package_path() {
  std::vector<fs::path> result;
  if (const char* variable = std::getenv("ROS_PACKAGE_PATH")) {
    std::istringstream folders(variable);
    for (std::string folder; std::getline(folders, folder, ':');)
      if (!folder.empty()) result.emplace_back(folder);
  }
  return result;
}

fs::path find_mesh(const std::string& reference, const fs::path& urdf_folder,
                   const std::vector<PackageFolder>& packages, const std::string& urdf_file) {
  const std::size_t scheme_end = reference.find("://");
  if (scheme_end == std::string::npos) return urdf_folder / reference;
  const std::string scheme = reference.substr(0, scheme_end);
  const std::string rest = reference.substr(scheme_end + 3);
  if (scheme == "file") return urdf_folder / rest;
  if (scheme != "package")
    throw Error(ErrorCode::file_unreadable, urdf_file, "the mesh " + reference + " is not on this machine",
                "download it and name it by a path, file:// or package://");

  const std::size_t name_end = rest.find('/');
  const std::string name = rest.substr(0, name_end);
  const std::string path_in_package = name_end == std::string::npos ? "" : rest.substr(name_end + 1);
  std::error_code ignored;  // a folder that cannot be looked into does not hold the file
  for (const fs::path& folder : package_candidates(name, urdf_folder, packages))
    if (fs::exists(folder / path_in_package, ignored)) return folder / path_in_package;
  throw Error(ErrorCode::file_unreadable, urdf_file, "the mesh " + reference + " is in no folder known for its package",
              "name its folder by ModelLoadOptions::packages or set ROS_PACKAGE_PATH");
}

}  // namespace uhas
