// What was measured, as a document, as aligned text and as Markdown.
#pragma once

#include <iosfwd>
#include <vector>

#include "machine.hpp"
#include "requirements.hpp"
#include "runtime_measurement.hpp"
#include "uhas/json/json_text.hpp"

namespace uhas::benchmark {

struct RuntimeReport {
  Machine machine;
  unsigned seed = 0;
  RuntimeSettings settings;
  std::vector<HandMeasurement> hands;
  PointGrowth growth;
  std::vector<Judgement> judgements;
};

/// `uhas-runtime-benchmark`, version 1: see runtime-benchmark.schema.json.
Json to_json(const RuntimeReport& report);

/// One table a hand: every work with median, p99 and worst; then the requirements.
void print_tables(const RuntimeReport& report, std::ostream& out);

/// Two tables for a page: medians of all works by hand, and the requirements.
void print_markdown(const RuntimeReport& report, std::ostream& out);

}  // namespace uhas::benchmark
