// The machine and the program that measured.
#pragma once

#include <string>

namespace uhas::benchmark {

struct Machine {
  std::string processor;
  unsigned processors = 0;      ///< that this process may use
  std::string instruction_set;  ///< that the library chose for batches
  std::string compiler;
  std::string build_type;
};

Machine this_machine();

/// Mean number of running processes over the last minute: 1 for a quiet machine that runs the benchmark.
double load_average();

}  // namespace uhas::benchmark
