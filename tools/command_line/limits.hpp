// Bounds on what a tool reads: one option, --limit NAME=N, and one table of the names that it takes.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "uhas/anatomy/hand_config.hpp"
#include "uhas/fence/child_process.hpp"
#include "uhas/model/hand_model.hpp"
#include "uhas/trajectory/trajectory.hpp"

namespace uhas::tools {

/// The most that a tool reads; man/uhas.7 says what each bounds, and for which tools.
struct Limits {
  std::uint64_t urdf_bytes = ModelLoadOptions{}.max_urdf_bytes;
  std::uint64_t links = ModelLoadOptions{}.max_links;
  std::uint64_t mesh_bytes = ModelLoadOptions{}.max_mesh_bytes;
  std::uint64_t triangles = ModelLoadOptions{}.max_triangles;
  std::uint64_t config_bytes = kMaxHandConfigBytes;
  std::uint64_t json_bytes = TrajectoryLimits{}.max_json_bytes;
  std::uint64_t actions = 1'000'000;
  std::uint64_t hdf5_bytes = TrajectoryLimits{}.max_hdf5_bytes;
  std::uint64_t read_seconds = ChildLimits{}.max_seconds;
  std::uint64_t read_memory = ChildLimits{}.max_memory_bytes;

  /// For the child processes that read what others wrote: URDFs, meshes, profiles, HDF5.
  ChildLimits child() const;
  TrajectoryLimits trajectory() const;

  /// Sets the bounds of `load`, `in_child` among them.
  void apply_to(ModelLoadOptions& load) const;
};

/// A limit as --limit names it.
struct NamedLimit {
  const char* name;
  std::uint64_t Limits::*value;
  const char* field;  ///< of the library, as its errors name it; null for what only the tools read
  std::uint64_t most = UINT64_MAX;
};

/// All of them, in the order of `Limits`.
const std::vector<NamedLimit>& named_limits();

/// What --help shows as the argument of --limit.
inline constexpr const char* kLimitArgument = "NAME=N";

/// --limit NAME=N, repeatable. N is a whole number, also with K, M or G for 1024, 1024^2 and 1024^3. The parser throws
/// CLI::ParseError for another name or number.
void add_limit_option(CLI::App& app, Limits& limits);

/// "raise the bound by --limit links=N".
std::string raise_limit(std::uint64_t Limits::*limit);

}  // namespace uhas::tools
