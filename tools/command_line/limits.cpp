#include "command_line/limits.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "command_line/tool.hpp"
#include "text/words.hpp"

namespace uhas::tools {
namespace {

/// A whole number of at least 1, with K, M or G for a power of 1024; nothing for anything else.
std::optional<std::uint64_t> count_of(std::string_view text) {
  constexpr std::string_view units = "KMG";
  std::uint64_t unit = 1;
  if (const std::size_t power = text.empty() ? units.npos : units.find(text.back()); power != units.npos) {
    unit <<= 10 * (power + 1);
    text.remove_suffix(1);
  }
  std::uint64_t count = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
  if (!whole || count == 0 || count > UINT64_MAX / unit) return std::nullopt;
  return count * unit;
}

std::string names() {
  std::vector<std::string> names;
  for (const NamedLimit& limit : named_limits()) names.emplace_back(limit.name);
  return join(names, ", ");
}

/// Sets the limit that `assignment`, NAME=N, is about.
void assign(Limits& limits, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, equals);
  const auto limit = std::ranges::find(named_limits(), name, &NamedLimit::name);
  if (limit == named_limits().end())
    throw Tool::wrong_usage("--limit", "there is no limit " + name + ", the limits are " + names());
  const std::optional<std::uint64_t> count =
      equals == std::string::npos ? std::nullopt : count_of(std::string_view(assignment).substr(equals + 1));
  if (!count || *count > limit->most)
    throw Tool::wrong_usage("--limit", assignment + " is not " + name + "=N, N a whole number from 1" +
                                           (limit->most < UINT64_MAX ? " to " + std::to_string(limit->most) : ""));
  limits.*(limit->value) = *count;
}

}  // namespace

ChildLimits Limits::child() const { return {.max_memory_bytes = read_memory, .max_seconds = read_seconds}; }

TrajectoryLimits Limits::trajectory() const {
  return {.max_json_bytes = json_bytes, .max_hdf5_bytes = hdf5_bytes, .in_child = child()};
}

void Limits::apply_to(ModelLoadOptions& load) const {
  load.max_urdf_bytes = urdf_bytes;
  load.max_links = links;
  load.max_mesh_bytes = mesh_bytes;
  load.max_triangles = triangles;
  load.in_child = child();
}

const std::vector<NamedLimit>& named_limits() {
  static const std::vector<NamedLimit> limits = {
      {"urdf-bytes", &Limits::urdf_bytes, "ModelLoadOptions::max_urdf_bytes"},
      // as many in a chain leave urdfdom's stack room
      {"links", &Limits::links, "ModelLoadOptions::max_links", 10'000},
      {"mesh-bytes", &Limits::mesh_bytes, "ModelLoadOptions::max_mesh_bytes"},
      {"triangles", &Limits::triangles, "ModelLoadOptions::max_triangles"},
      {"config-bytes", &Limits::config_bytes, "the max_bytes of read_hand_config"},
      {"json-bytes", &Limits::json_bytes, "TrajectoryLimits::max_json_bytes"},
      {"actions", &Limits::actions, nullptr},
      {"hdf5-bytes", &Limits::hdf5_bytes, "TrajectoryLimits::max_hdf5_bytes"},
      {"read-seconds", &Limits::read_seconds, "ChildLimits::max_seconds"},
      {"read-memory", &Limits::read_memory, "ChildLimits::max_memory_bytes"}};
  return limits;
}

void add_limit_option(CLI::App& app, Limits& limits) {
  const auto assign_all = [&limits](const std::vector<std::string>& assignments) {
    for (const std::string& assignment : assignments) assign(limits, assignment);
  };
  app.add_option_function<std::vector<std::string>>(
         "--limit", assign_all, "Refuse what is larger, for example mesh-bytes=1G; repeatable, uhas(7) has the names")
      ->allow_extra_args(false)
      ->option_text(kLimitArgument);
}

std::string raise_limit(std::uint64_t Limits::*limit) {
  const auto named = std::ranges::find(named_limits(), limit, &NamedLimit::value);
  return "raise the bound by --limit " + std::string(named->name) + "=N";
}

}  // namespace uhas::tools
