// Work that a hostile file may bring down, done in a process of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "uhas/base/errors.hpp"

namespace uhas {

struct ChildLimits {
  std::uint64_t max_memory_bytes = std::uint64_t{4} << 30;  ///< beyond what the calling process holds; of each result, too
  double max_seconds = 60;
};

/// What `work(i)` returns for each of `files`, found in order in one copy of this process: whatever `work` does to memory
/// is undone with the copy, and a crash, a hang or boundless memory there is an Error here. It is a fence against mishap,
/// not a jail: the copy may still read files and talk to the world, though it can write no file. For set-up code; while
/// it runs, no other thread may hold a lock that `work` needs.
/// @param limits  the memory is for all files together, the time for each
/// @param blame   the code of the error for a copy that crashes
/// @param files   what `work` reads, for errors: one is blamed for what happens while it is read
/// Throws what `work` throws (an Error with its code, everything else as `blame`); Error: `blame`, limit_exceeded.
std::vector<std::vector<std::byte>> in_child(const ChildLimits& limits, ErrorCode blame,
                                             std::span<const std::string> files,
                                             const std::function<std::vector<std::byte>(std::size_t i)>& work);

/// The same for one file.
std::vector<std::byte> in_child(const ChildLimits& limits, ErrorCode blame, const std::string& file,
                                const std::function<std::vector<std::byte>()>& work);

}  // namespace uhas
