#include "uhas/trajectory/trajectory.hpp"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "command_line/tool.hpp"
#include "uhas/trajectory/hdf5/trajectory_hdf5.hpp"
#include "uhas/trajectory/hdf5/trajectory_in_child.hpp"
#include "uhas/trajectory/trajectory_json.hpp"
#include "uhas/base/errors.hpp"

namespace uhas {

TrajectoryKind trajectory_kind(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".json") return TrajectoryKind::json;
  if (extension == ".jsonl") return TrajectoryKind::json_lines;
  if (extension == ".h5" || extension == ".hdf5") return TrajectoryKind::hdf5;
  throw Tool::wrong_usage(path, "the name of a trajectory ends in .json, .jsonl, .h5 or .hdf5");
}

void TrajectorySummary::add(const EncodeReport& report) {
  if (report.residual_max > residual_max) residual_max = report.residual_max, worst_frame = frames;
  if (report.residual_max > kTolerance) ++off_manifold;
  sum_of_squares += report.residual_rms * report.residual_rms;
  ++frames;
}

double TrajectorySummary::residual_rms() const {
  return frames == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(frames));
}

std::unique_ptr<TrajectoryReader> open_trajectory(const std::string& path, const TrajectoryLimits& limits,
                                                  const ChildLimits& child_limits) {
  const TrajectoryKind kind = trajectory_kind(path);
  if (std::error_code ignored; !std::filesystem::exists(path, ignored))
    throw Error(ErrorCode::file_unreadable, path, "the file does not exist", "check the path");
  if (::access(path.c_str(), R_OK) != 0)
    throw Error(ErrorCode::file_unreadable, path, "cannot be opened: " + std::generic_category().message(errno),
                "check the path and its permissions");
  switch (kind) {
    case TrajectoryKind::json: return open_json_trajectory(path, limits.max_json_bytes);
    case TrajectoryKind::json_lines: return open_json_lines_trajectory(path);
    case TrajectoryKind::hdf5: break;
  }
  return open_hdf5_trajectory_in_child(path, limits.max_hdf5_bytes, child_limits);
}

std::unique_ptr<TrajectoryWriter> create_trajectory(TrajectoryKind kind, const std::string& path,
                                                    const TrajectoryHeader& header) {
  switch (kind) {
    case TrajectoryKind::json: return create_json_trajectory(path, header);
    case TrajectoryKind::json_lines: return create_json_lines_trajectory(path, header);
    case TrajectoryKind::hdf5: break;
  }
  return create_hdf5_trajectory(path, header);
}

}  // namespace uhas
