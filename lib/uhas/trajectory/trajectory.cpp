#include "uhas/trajectory/trajectory.hpp"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "uhas/base/errors.hpp"
#include "uhas/trajectory/formats/hdf5_in_child.hpp"
#include "uhas/trajectory/formats/hdf5_writer.hpp"
#include "uhas/trajectory/formats/json_reader.hpp"
#include "uhas/trajectory/formats/json_writer.hpp"

namespace uhas {

std::optional<TrajectoryKind> trajectory_kind(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".json") return TrajectoryKind::json;
  if (extension == ".jsonl") return TrajectoryKind::json_lines;
  if (extension == ".h5" || extension == ".hdf5") return TrajectoryKind::hdf5;
  return std::nullopt;
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

std::unique_ptr<TrajectoryReader> open_trajectory(TrajectoryKind kind, const std::string& path,
                                                  const TrajectoryLimits& limits) {
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
  return open_hdf5_trajectory_in_child(path, limits.max_hdf5_bytes, limits.in_child);
}

std::unique_ptr<TrajectoryWriter> create_trajectory(TrajectoryKind kind, const std::string& path,
                                                    const TrajectoryHeader& header) {
  switch (kind) {
    case TrajectoryKind::json: return write_json_trajectory(TextTarget(path), header);
    case TrajectoryKind::json_lines: return write_json_lines_trajectory(TextTarget(path), header);
    case TrajectoryKind::hdf5: break;
  }
  return create_hdf5_trajectory(path, header);
}

std::unique_ptr<TrajectoryWriter> stream_trajectory(TrajectoryKind kind, std::ostream& out,
                                                    const TrajectoryHeader& header) {
  if (kind == TrajectoryKind::json) return write_json_trajectory(TextTarget(out), header);
  return write_json_lines_trajectory(TextTarget(out), header);
}

}  // namespace uhas
