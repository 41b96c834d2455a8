// Trajectories written as JSON and JSON Lines.
#pragma once

#include <string_view>

#include "uhas/files/file_replacement.hpp"
#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

/// Where text goes: a file, which appears whole by `finish` or not at all, or a stream.
class TextTarget {
 public:
  explicit TextTarget(const std::string& path)
      : file_(std::make_unique<FileReplacement>(path)) {}          ///< throws Error(write_failed)
  explicit TextTarget(std::ostream& stream) : stream_(&stream) {}  ///< which must outlive this
  void write(std::string_view text);                               ///< throws Error(write_failed)
  void finish();                                                   ///< throws Error(write_failed)

 private:
  std::unique_ptr<FileReplacement> file_;
  std::ostream* stream_ = nullptr;
};

std::unique_ptr<TrajectoryWriter> write_json_trajectory(TextTarget target, const TrajectoryHeader& header);
std::unique_ptr<TrajectoryWriter> write_json_lines_trajectory(TextTarget target, const TrajectoryHeader& header);

}  // namespace uhas
