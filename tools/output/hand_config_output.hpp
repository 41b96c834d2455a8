// A hand config of what was inferred, for the tools that write one to correct.
#pragma once

#include <string>

#include "command_line/tool.hpp"
#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::tools {

/// --write-config FILE.
void add_write_config_option(Tool& tool, std::string& path);

/// Writes what was inferred as a complete hand config (schemas/hand-config.schema.json); does nothing for an empty
/// path. The file appears whole or not at all. Throws Error(write_failed).
void write_hand_config(const std::string& path, const BuildStages& stages, const BuildSettings& settings);

}  // namespace uhas::tools
