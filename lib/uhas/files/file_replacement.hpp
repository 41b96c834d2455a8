// A file that takes the place of another when it is whole: written, synced, renamed.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace uhas {

/// A new file beside `path`, a symbolic link at which is followed. It becomes `path` by `commit`; without, the old file
/// is untouched and nothing stays behind.
class FileReplacement {
 public:
  /// Throws Error(write_failed).
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();

  /// The new file, which exists and is empty; a library may write it by name instead of `write`.
  const std::string& temporary_path() const noexcept;

  /// Appends. Throws Error(write_failed).
  void write(std::span<const std::byte> bytes);

  /// Syncs the new file, renames it to `path` and syncs the folder. Throws Error(write_failed).
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace uhas
