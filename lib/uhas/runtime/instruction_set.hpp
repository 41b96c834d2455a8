// Which of the processor's wide instructions the batch calls use. Chosen when an object is constructed, at run time:
// the library itself is compiled for the oldest processor of its kind.
#pragma once

#include "uhas/base/export.hpp"

namespace uhas {

enum class InstructionSet : int {
  /// One hand after the other, by the code of a single solve. Use this as what the others are compared with.
  scalar = 0,
  /// 128 bits, which every x86-64 and aarch64 processor has: 4 floats or 2 doubles. Use this to get the same bits on
  /// processors with AVX2 and without.
  baseline = 1,
  /// AVX2 and FMA, 256 bits: 8 floats or 4 doubles. Use this where it is available: it is the fastest.
  avx2 = 2,
};

/// Whether this library was built with `set` and this processor has it.
UHAS_API bool is_available(InstructionSet set) noexcept;

/// The widest one available, but none wider than the environment variable UHAS_INSTRUCTION_SET names:
/// `scalar`, `baseline` or `avx2`. Any other value counts as unset. Reads the environment: for set-up code,
/// not for the real-time path.
UHAS_API InstructionSet widest_instruction_set() noexcept;

/// The name above; never null.
UHAS_API const char* to_string(InstructionSet set) noexcept;

}  // namespace uhas
