// The user block: the first 512 bytes of a profile, which HDF5 ignores. It vouches for the rest of the file.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace uhas {

inline constexpr std::size_t kUserBlockBytes = 512;

struct FormatVersion {
  int major = 0, minor = 0;
  friend bool operator==(FormatVersion, FormatVersion) = default;
};

/// The version that the user block of a whole file states; empty when the file has no hand profile's user block.
std::optional<FormatVersion> stated_version(std::span<const std::byte> file);

/// Writes the user block over the first 512 bytes of `file`, the bytes of a whole file.
void write_user_block(std::span<std::byte> file, FormatVersion version);

/// Checks that `file`, the bytes of a whole file called `path`, is what its user block says, and returns its version.
/// Throws Error: invalid_profile, unsupported_version.
FormatVersion check_user_block(std::span<const std::byte> file, const std::string& path);

}  // namespace uhas
