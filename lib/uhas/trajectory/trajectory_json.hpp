// What trajectories in JSON and JSON Lines are made of: a header, frames, a summary.
#pragma once

#include <optional>

#include "uhas/json/json_text.hpp"
#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

inline constexpr const char* kTrajectoryFormat = "uhas-trajectory";

/// {"format": "uhas-trajectory", "version": 1, "hand": ..., "joint_names": [...]}: a document without its frames, or
/// the first of its lines.
Json to_json(const TrajectoryHeader& header);

/// The header that `value` is; nothing when it is no object with "format" or "joint_names". Throws Error: syntax,
/// unsupported_version in the name of `place`.
std::optional<TrajectoryHeader> header_of(const Json& value, const std::string& place);

/// A frame: [q, ...] or {"q": [q, ...]}; other keys are passed over. Throws Error(syntax) in the name of `place`.
std::vector<double> frame_of(const Json& value, std::size_t joints, const std::string& place);

/// {"q": [...], "residual_max": ..., "residual_rms": ...}
Json to_json(std::span<const double> q, const EncodeReport& report);

/// {"frames": ..., "off_manifold": ..., ...}
Json to_json(const TrajectorySummary& summary);

}  // namespace uhas
