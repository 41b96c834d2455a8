// The options of every tool that starts from a URDF, and the stages run with them.
#pragma once

#include <string>
#include <vector>

#include "command_line/tool.hpp"
#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::tools {

struct HandInput {
  std::string urdf;
  std::string config_file;  ///< hand config; empty = infer everything
  BuildSettings settings;
};

/// hand.urdf, --config, those of `add_load_options`, --geometry, --radius-scale, --merge-pinky.
void add_hand_options(CLI::App& app, HandInput& input);

/// --package NAME=DIR, repeatable, and --allow-outside.
void add_load_options(CLI::App& app, ModelLoadOptions& load);

/// --lateral-steps N.
void add_lateral_options(CLI::App& app, LateralTableOptions& options);

/// --samples N and --points-per-link N.
void add_surface_options(CLI::App& app, CorrespondenceOptions& options);

/// Tells the tool's guard of files which ones `model` was read from.
void read_model_files(Tool& tool, const HandModel& model);

/// Reads the hand config and runs the stages up to `last`, with progress and warnings on stderr.
BuildStages run_stages(Tool& tool, HandInput& input, BuildStage last);

}  // namespace uhas::tools
