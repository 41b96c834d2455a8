#include "uhas/trajectory/trajectory_json.hpp"

#include <algorithm>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

Error wrong(const std::string& place, const std::string& problem, const std::string& remedy) {
  return {ErrorCode::syntax, place, problem, remedy};
}

}  // namespace

Json to_json(const TrajectoryHeader& header) {
  Json document = new_document(kTrajectoryFormat);
  document["hand"] = header.hand;
  document["joint_names"] = header.joint_names;
  return document;
}

std::optional<TrajectoryHeader> header_of(const Json& value, const std::string& place) {
  if (!value.is_object() || (!value.contains("format") && !value.contains("joint_names"))) return std::nullopt;
  if (value.value("format", Json()) != kTrajectoryFormat)
    throw wrong(place, "is not a trajectory: no \"format\": \"uhas-trajectory\"", "see schemas/trajectory.schema.json");
  if (const Json version = value.value("version", Json()); version != 1)
    throw Error(ErrorCode::unsupported_version, place, "version is " + version.dump() + ", this tool reads 1",
                "write \"version\": 1");
  const Json names = value.value("joint_names", Json());
  const Json hand = value.value("hand", Json(""));
  const auto is_text = [](const Json& element) { return element.is_string(); };
  if (!names.is_array() || !std::ranges::all_of(names, is_text) || !hand.is_string())
    throw wrong(place, "joint_names is not an array of names, or hand is not a name",
                "name the joints in the order of the values");
  return TrajectoryHeader{hand.get<std::string>(), names.get<std::vector<std::string>>()};
}

std::vector<double> frame_of(const Json& value, std::size_t joints, const std::string& place) {
  const Json& q = value.is_object() && value.contains("q") ? value["q"] : value;
  const auto is_number = [](const Json& element) { return element.is_number(); };
  if (!q.is_array() || !std::ranges::all_of(q, is_number))
    throw wrong(place, "is not a frame", R"(write an array of numbers, or {"q": [numbers]})");
  if (q.size() != joints)
    throw wrong(place, "has " + std::to_string(q.size()) + " values for " + std::to_string(joints) + " joints",
                "write one for each joint of joint_names");
  return q.get<std::vector<double>>();
}

Json to_json(std::span<const double> q, const EncodeReport& report) {
  return {{"q", std::vector<double>(q.begin(), q.end())},
          {"residual_max", report.residual_max},
          {"residual_rms", report.residual_rms}};
}

Json to_json(const TrajectorySummary& summary) {
  return {{"frames", summary.frames},
          {"off_manifold", summary.off_manifold},
          {"tolerance", TrajectorySummary::kTolerance},
          {"residual_rms", summary.residual_rms()},
          {"residual_max", summary.residual_max},
          {"worst_frame", summary.frames == 0 ? Json() : Json(summary.worst_frame)}};
}

}  // namespace uhas
