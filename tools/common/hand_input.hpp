// The options of every tool that starts from a URDF, and the stages run with them.
#pragma once

#include <string>
#include <vector>

#include "common/tool.hpp"
#include "uhas/profile_builder/build_profile.hpp"

namespace uhas::tools {

struct HandInput {
  std::string urdf;
  std::string config_file;  ///< hand config; empty = infer everything
  BuildSettings settings;
};

/// hand.urdf, --config, --package, --geometry, --radius-scale, --merge-pinky.
void add_hand_options(CLI::App& app, HandInput& input);

/// --package NAME=DIR, repeatable.
void add_package_option(CLI::App& app, std::vector<PackageFolder>& packages);

/// --lateral-steps N.
void add_lateral_options(CLI::App& app, LateralTableOptions& options);

/// --samples N and --points-per-link N.
void add_surface_options(CLI::App& app, CorrespondenceOptions& options);

/// Reads the hand config and runs the stages up to `last`, with progress and warnings on stderr.
BuildStages run_stages(const Tool& tool, HandInput& input, Stage last);

}  // namespace uhas::tools
