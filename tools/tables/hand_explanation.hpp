// What was inferred of a hand: told to people and to machines, and written as a hand config to correct.
#pragma once

#include <iosfwd>
#include <string>

#include "command_line/tool.hpp"
#include "uhas/json/json_text.hpp"
#include "uhas/profile_builder/build_profile.hpp"

namespace uhas::tools {

/// {"format": "uhas-hand-explanation", ...} (schemas/hand-explanation.schema.json).
Json hand_explanation_json(const BuildStages& stages, const BuildSettings& settings);

/// The findings, then each finger with its joints and its tip.
void print_hand_explanation(std::ostream& out, const BuildStages& stages);

/// --write-config FILE.
void add_write_config_option(CLI::App& app, std::string& path);

/// Writes what was inferred as a complete hand config (schemas/hand-config.schema.json); does nothing for an empty
/// path. The file appears whole or not at all. Throws Error(write_failed).
void write_hand_config(const std::string& path, const BuildStages& stages, const BuildSettings& settings);

}  // namespace uhas::tools
