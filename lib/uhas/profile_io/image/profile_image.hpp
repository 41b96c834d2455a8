// A hand profile as the bytes of its HDF5 file, in memory: what is checked is what is parsed, and what is hashed is
// what is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/profile_io/image/user_block.hpp"

namespace uhas {

inline constexpr std::uint64_t kMaxProfileBytes = 256u << 20;

/// The whole file of `profile`, sealed. `path` is for error messages. Throws Error: limit_exceeded, write_failed.
std::vector<std::byte> image_of_profile(const HandProfile& profile, const std::string& path);

/// The profile in the bytes of a whole file of version `version`, validated. The user block is not looked at.
/// Throws Error: invalid_profile, limit_exceeded.
HandProfile profile_of_image(std::span<const std::byte> image, FormatVersion version, const std::string& path);

}  // namespace uhas
