// Work that a hostile file may bring down, done in a process of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "uhas/base/errors.hpp"

namespace uhas {

struct ChildLimits {
  std::uint64_t max_memory_bytes = std::uint64_t{2} << 30;  ///< beyond what the calling process holds; of the result, too
  double max_seconds = 60;
};

/// The bytes that `work` returns, found in a copy of this process: whatever `work` does to memory is undone with the
/// copy, and a crash, a hang or boundless memory there is an Error here. It is a fence against mishap, not a jail: the
/// copy may still read files and talk to the world, though it can write no file. For set-up code; while it runs, no
/// other thread may hold a lock that `work` needs.
/// @param blame  the code of the error for a copy that crashes
/// @param file   what `work` reads, for errors
/// Throws what `work` throws (an Error with its code, everything else as `blame`); Error: `blame`, limit_exceeded.
std::vector<std::byte> in_child(const ChildLimits& limits, ErrorCode blame, const std::string& file,
                                const std::function<std::vector<std::byte>()>& work);

}  // namespace uhas
