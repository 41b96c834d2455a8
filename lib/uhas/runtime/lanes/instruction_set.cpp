#include "uhas/runtime/instruction_set.hpp"

#include <cstdlib>
#include <string_view>

namespace uhas {

bool is_available(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::scalar:
    case InstructionSet::baseline: return true;
    case InstructionSet::avx2:
#ifdef UHAS_HAS_AVX2_SOURCES
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
      return false;
#endif
  }
  return false;
}

InstructionSet widest_instruction_set() noexcept {
  const char* wish = std::getenv("UHAS_INSTRUCTION_SET");
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline})
    if (wish != nullptr && std::string_view(wish) == to_string(set)) return set;
  return is_available(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::baseline;
}

const char* to_string(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::scalar: return "scalar";
    case InstructionSet::baseline: return "baseline";
    case InstructionSet::avx2: return "avx2";
  }
  return "unknown";
}

}  // namespace uhas
