#include "uhas/profile_io/image/user_block.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "uhas/base/errors.hpp"
#include "uhas/files/sha256.hpp"
#include "uhas/profile/hand_profile.hpp"
#include "uhas/profile_io/image/profile_error.hpp"

namespace uhas {
namespace {

/// The one user block that a file of this version and content can have: three lines of text, padded with zeros.
std::string expected_block(std::span<const std::byte> file, FormatVersion version) {
  std::string block = "uhas-hand-profile " + std::to_string(version.major) + "." + std::to_string(version.minor) +
                      "\nlength " + std::to_string(file.size()) +  //
                      "\nsha256 " + sha256_hex(file.subspan(kUserBlockBytes)) + "\n";
  block.resize(kUserBlockBytes, '\0');
  return block;
}

/// The text of the user block, as far as the file goes.
std::string block_text(std::span<const std::byte> file) {
  const std::size_t size = std::min(file.size(), kUserBlockBytes);
  return {reinterpret_cast<const char*>(file.data()), size};
}

}  // namespace

std::optional<FormatVersion> stated_version(std::span<const std::byte> file) {
  FormatVersion version;
  int end = 0;  // widths keep the numbers in range; %n is reached only by a whole first line
  std::sscanf(block_text(file).c_str(), "uhas-hand-profile %4d.%4d\n%n", &version.major, &version.minor, &end);
  if (end == 0) return std::nullopt;
  return version;
}

void write_user_block(std::span<std::byte> file, FormatVersion version) {
  const std::string block = expected_block(file, version);
  std::memcpy(file.data(), block.data(), kUserBlockBytes);
}

FormatVersion check_user_block(std::span<const std::byte> file, const std::string& path) {
  if (file.empty()) throw profile_error(path, "the file is empty");
  const std::optional<FormatVersion> version = stated_version(file);
  if (!version)
    throw profile_error(path, "this is not a hand profile: it does not begin with 'uhas-hand-profile'",
                        "name a file that uhas-build-profile wrote");
  if (version->major != kProfileVersionMajor)
    throw Error(ErrorCode::unsupported_version, path,
                "the profile has format version " + std::to_string(version->major) + "." +
                    std::to_string(version->minor) + ", this reader knows version " +
                    std::to_string(kProfileVersionMajor) + "." + std::to_string(kProfileVersionMinor),
                rebuild_remedy);

  const std::string block = block_text(file);
  unsigned long long length = 0;
  const bool has_length = std::sscanf(block.c_str(), "%*[^\n]\nlength %15llu", &length) == 1;
  if (!has_length || file.size() < kUserBlockBytes || file.size() < length)
    throw profile_error(path, "the file is truncated: it has " + std::to_string(file.size()) + " bytes" +
                                  (has_length ? " of " + std::to_string(length) : ""));
  if (block != expected_block(file, *version))
    throw profile_error(path, "the file is damaged: its content does not have the SHA-256 and length that it states",
                        "rebuild it with uhas-build-profile, or reseal it with uhas-inspect if you edited it");
  return *version;
}

}  // namespace uhas
