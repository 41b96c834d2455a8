// Reading a whole file, with a bound on its size and a record of its bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::detail {

using FileBytes = std::vector<std::byte>;

/// The bytes of a regular file.
/// Throws Error: file_unreadable when it is missing, no regular file or not readable; limit_exceeded above `max_bytes`.
FileBytes read_file(const std::filesystem::path& path, std::uint64_t max_bytes);

/// The files a model was read from, each once, in order of use.
class SourceLog {
 public:
  explicit SourceLog(std::filesystem::path urdf_folder) : urdf_folder_(std::move(urdf_folder)) {}

  /// @param path       where the file was found
  /// @param reference  how the URDF names it; kept as the name when it is a package:// reference, else the name is
  ///                   `path` relative to the URDF's folder
  void add(const std::filesystem::path& path, const std::string& reference, std::span<const std::byte> bytes);

  const std::vector<SourceFile>& files() const { return files_; }

 private:
  std::filesystem::path urdf_folder_;
  std::vector<SourceFile> files_;
};

}  // namespace uhas::detail
