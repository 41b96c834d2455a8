// The scores of hands, as tables.
#pragma once

#include <iosfwd>

#include "json/evaluation_json.hpp"

namespace uhas::tools {

/// A row a score, a column a hand; of two hands also the difference. One hand's fingers follow in tables of their own.
void print_evaluation(std::ostream& out, const EvaluationRun& run);

/// The first of these tables in Markdown, a row a hand.
void print_evaluation_markdown(std::ostream& out, const EvaluationRun& run);

}  // namespace uhas::tools
