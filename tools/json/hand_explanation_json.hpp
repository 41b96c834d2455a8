// What was inferred of a hand, as JSON documents: to be read, and as a hand config to correct.
#pragma once

#include "uhas/json/json_text.hpp"
#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::tools {

/// {"format": "uhas-hand-explanation", ...} (schemas/hand-explanation.schema.json).
Json hand_explanation_json(const BuildStages& stages, const BuildSettings& settings);

/// A complete hand config (schemas/hand-config.schema.json).
Json hand_config_json(const BuildStages& stages, const BuildSettings& settings);

}  // namespace uhas::tools
