// A promise (docs/performance.md) and what was measured of it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "uhas/json/json_text.hpp"

namespace uhas::benchmark {

enum class Verdict { aim, must, missed };

struct Judgement {
  std::string requirement;
  bool at_most;  ///< the value may not be above `must`; else not below
  double must, aim;
  double value;      ///< of several hands that of the worst
  std::string hand;  ///< the worst, or what else the value is of

  Verdict verdict() const;
};

Json to_json(const std::vector<Judgement>& judgements);
void print_table(const std::vector<Judgement>& judgements, std::ostream& out);
void print_markdown(const std::vector<Judgement>& judgements, std::ostream& out);

/// A row of a Markdown table.
void print_markdown_row(const std::vector<std::string>& cells, std::ostream& out);
/// The header and the line below it: the first column to the left, the others to the right.
void print_markdown_header(const std::vector<std::string>& columns, std::ostream& out);

}  // namespace uhas::benchmark
