// The scores of hands, for people and for machines.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "uhas/json/json_text.hpp"
#include "uhas/evaluation/evaluation.hpp"

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

/// A row a score, a column a hand; of two hands also the difference. One hand's fingers follow in tables of their own.
void print_evaluation(std::ostream& out, const EvaluationRun& run);

/// The first of these tables in Markdown, a row a hand.
void print_evaluation_markdown(std::ostream& out, const EvaluationRun& run);

}  // namespace uhas::tools
