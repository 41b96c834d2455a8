#include "uhas/model/meshes/mesh_folders.hpp"

#include <algorithm>

#include "uhas/base/errors.hpp"
#include "uhas/model/meshes/mesh_path.hpp"

namespace uhas {
namespace {

namespace fs = std::filesystem;

/// Absolute, without symbolic links, "." and ".."; as it is named where links cannot be followed, so neither can
/// they be read.
fs::path resolved(const fs::path& path) {
  std::error_code failure;
  const fs::path full = fs::current_path() / path;
  const fs::path canonical = fs::weakly_canonical(full, failure);
  const fs::path result = failure ? full.lexically_normal() : canonical;
  return result.has_filename() ? result : result.parent_path();  // no slash at the end
}

fs::path folder_of_model(const std::string& urdf_file) {
  const fs::path urdf_folder = resolved(urdf_file).parent_path();
  std::error_code ignored;
  for (fs::path folder = urdf_folder; folder != folder.root_path(); folder = folder.parent_path())
    if (fs::exists(folder / "package.xml", ignored)) return folder;
  const fs::path around = urdf_folder.parent_path();
  return around == around.root_path() ? urdf_folder : around;  // never the whole machine
}

bool is_below(const fs::path& file, const fs::path& folder) {
  return !folder.empty() && std::ranges::mismatch(folder, file).in1 == folder.end();
}

}  // namespace

MeshFolders::MeshFolders(const std::string& urdf_file, const ModelLoadOptions& options)
    : urdf_file_(urdf_file), hold_all_(options.allow_outside), folders_{folder_of_model(urdf_file)} {
  for (const PackageFolder& package : options.packages) folders_.push_back(resolved(package.folder));
  for (const fs::path& folder : ros_package_path()) folders_.push_back(resolved(folder));
}

bool MeshFolders::hold(const fs::path& file) const {
  const fs::path path = resolved(file);
  return hold_all_ || std::ranges::any_of(folders_, [&](const fs::path& folder) { return is_below(path, folder); });
}

void MeshFolders::require(const fs::path& file, const std::string& reference) const {
  if (hold(file)) return;
  throw Error(
      ErrorCode::file_unreadable, urdf_file_,
      "the mesh " + reference + " lies outside " + folders_.front().string() + ", the folder of the model",
      "name its package by ModelLoadOptions::packages, or set ModelLoadOptions::allow_outside if you trust the model");
}

}  // namespace uhas
