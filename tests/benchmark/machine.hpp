// The machine and the program that measured.
#pragma once

#include <iosfwd>
#include <string>

#include "uhas/json/json_text.hpp"

namespace uhas::benchmark {

struct Machine {
  std::string processor;
  unsigned processors = 0;      ///< that this process may use
  std::string instruction_set;  ///< that the library chose for batches
  std::string compiler;
  std::string build_type;
  double load_before = 0, load_after = 0;  ///< load averages, before and after measuring
};

/// The machine before measuring.
Machine this_machine();

Json to_json(const Machine& machine);

/// One line.
void print_machine(const Machine& machine, std::ostream& out);

/// Mean number of running processes over the last minute: 1 for a quiet machine that runs the benchmark.
double load_average();

}  // namespace uhas::benchmark
