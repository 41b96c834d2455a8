// Bounds for reading what others wrote.
#pragma once

#include <cstdint>

namespace uhas {

/// Reading under these limits is done in a copy of this process, so that a file that crashes a library, or has it run
/// without end, is an Error here. It is a fence against mishap, not a jail. While the copy is made, no other thread may
/// hold a lock that the reading needs.
struct ChildLimits {
  std::uint64_t max_memory_bytes = std::uint64_t{4}
                                   << 30;  ///< beyond what the calling process holds; of each result, too
  std::uint64_t max_seconds = 60;          ///< for each result
};

}  // namespace uhas
