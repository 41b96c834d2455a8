// The scores of hands, as a JSON document.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "uhas/evaluation/evaluation.hpp"
#include "uhas/json/json_text.hpp"

namespace uhas::tools {

/// A hand and its scores.
struct EvaluatedHand {
  std::string label;  ///< the hand's name, told apart from others of the same name
  HandProfile profile;
  Evaluation evaluation;
};

/// What the scores of all hands are from.
struct EvaluationRun {
  EvaluationOptions options;
  std::vector<EvaluatedHand> hands;
};

/// A document of schemas/evaluation.schema.json, of these hands of the run.
Json evaluation_json(const EvaluationRun& run, std::span<const EvaluatedHand> hands);

}  // namespace uhas::tools
