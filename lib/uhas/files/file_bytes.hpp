// Whole files as bytes: bounded reading and atomic replacement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace uhas {

/// All bytes of the regular file `path`. Throws Error: file_unreadable; limit_exceeded, with `remedy`, when it has
/// more than `max_bytes`.
std::vector<std::byte> read_file(const std::string& path, std::uint64_t max_bytes,
                                 const std::string& remedy = "make sure that it is the right file");

/// Makes `bytes` the content of `path`, following a symbolic link: writes and syncs a temporary file in the same
/// folder, renames it, syncs the folder. On failure the old file is untouched and no temporary file stays behind.
/// Throws Error(write_failed).
void replace_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace uhas
