#include "machine.hpp"

#include <cstdlib>
#include <fstream>
#include <thread>

#include "uhas/runtime/instruction_set.hpp"

namespace uhas::benchmark {
namespace {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

Machine this_machine() {
  return {processor_name(), std::thread::hardware_concurrency(), to_string(widest_instruction_set()),
          "GCC " __VERSION__, UHAS_BUILD_TYPE};
}

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace uhas::benchmark
