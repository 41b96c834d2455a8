// Which folders a URDF may read from: a model from a stranger has no business with other files of the machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas {

/// See `ModelLoadOptions::allow_outside`.
class MeshFolders {
 public:
  MeshFolders(const std::string& urdf_file, const ModelLoadOptions& options);

  /// Symbolic links are followed first; a file that does not exist is where its name says.
  bool hold(const std::filesystem::path& file) const;

  /// Throws Error(file_unreadable) when the file is in none of the folders. `reference` is how the URDF names it.
  void require(const std::filesystem::path& file, const std::string& reference) const;

 private:
  std::string urdf_file_;
  bool hold_all_;
  std::vector<std::filesystem::path> folders_;  // canonical; the model's own first
};

}  // namespace uhas
