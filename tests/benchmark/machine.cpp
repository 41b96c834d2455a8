#include "machine.hpp"

#include <cstdlib>
#include <fstream>
#include <ostream>
#include <thread>

#include "text/numbers.hpp"
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
  return {processor_name(),
          std::thread::hardware_concurrency(),
          to_string(widest_instruction_set()),
          "GCC " __VERSION__,
          UHAS_BUILD_TYPE,
          load_average(),
          0};
}

Json to_json(const Machine& machine) {
  return {{"processor", machine.processor},
          {"processors", machine.processors},
          {"instruction_set", machine.instruction_set},
          {"compiler", machine.compiler},
          {"build_type", machine.build_type},
          {"load_average", {{"before", machine.load_before}, {"after", machine.load_after}}}};
}

void print_machine(const Machine& machine, std::ostream& out) {
  out << machine.processor << ", " << machine.processors << " processors; batches use " << machine.instruction_set
      << "; " << machine.compiler << ", " << machine.build_type << "; load average "
      << tools::fixed(machine.load_before, 2) << " before, " << tools::fixed(machine.load_after, 2) << " after\n";
}

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace uhas::benchmark
