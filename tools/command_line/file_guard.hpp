// What a run may write to: never what it reads, and of other files only those that it could have written before.
#pragma once

#include <string>
#include <vector>

namespace uhas::tools {

/// What a tool writes to a file.
enum class FileKind { profile, hand_config, solution, surface_points, trajectory, html, glb, ply, svg };

/// Knows the files of a run. Two names are one file when they lead to one inode, whatever links lie between.
class FileGuard {
 public:
  /// Lets existing files of another kind, and read-only ones, be replaced. Must come before the first `write`.
  void force() { forced_ = true; }

  /// `path` is read. Throws Error(write_failed) when it is written as well.
  void read(const std::string& path);

  /// `path` will be written. Throws Error(write_failed) when it is read as well, when two results go there, or when a
  /// file is there that is read-only or not of this kind. Empty files, pipes and devices hold nothing to lose.
  void write(const std::string& path, FileKind kind);

  /// `path` is read, then written anew. Throws Error(write_failed) when it is read-only.
  void rewrite(const std::string& path) const;

 private:
  bool forced_ = false;
  std::vector<std::string> inputs_, outputs_;
};

}  // namespace uhas::tools
