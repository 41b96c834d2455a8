// Trajectories read from JSON and JSON Lines.
#pragma once

#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

/// Both throw Error: file_unreadable, limit_exceeded, syntax, unsupported_version; their readers throw Error(syntax).
std::unique_ptr<TrajectoryReader> open_json_trajectory(const std::string& path, std::uint64_t max_bytes);
std::unique_ptr<TrajectoryReader> open_json_lines_trajectory(const std::string& path);

}  // namespace uhas
