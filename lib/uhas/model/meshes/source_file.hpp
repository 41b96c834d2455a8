// A record of the files that a model was read from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

struct LoggedFile {
  SourceFile source;
  std::string path;  ///< where it was found

  bool operator==(const LoggedFile&) const = default;
};

/// The files a model was read from, each once, in order of use.
class SourceLog {
 public:
  explicit SourceLog(std::filesystem::path urdf_folder) : urdf_folder_(std::move(urdf_folder)) {}

  /// @param path       where the file was found
  /// @param reference  how the URDF names it; kept as the name when it is a package:// reference, else the name is
  ///                   `path` relative to the URDF's folder
  void add(const std::filesystem::path& path, const std::string& reference, std::span<const std::byte> bytes);

  const std::vector<LoggedFile>& files() const { return files_; }

  /// The log that a child process has kept on, instead.
  void replace(std::vector<LoggedFile> files) { files_ = std::move(files); }

 private:
  std::filesystem::path urdf_folder_;
  std::vector<LoggedFile> files_;
};

}  // namespace uhas
