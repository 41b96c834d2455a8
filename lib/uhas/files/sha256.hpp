// SHA-256 (FIPS 180-4): names the bytes of every source file and guards hand profiles against damage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace uhas {

/// The SHA-256 of bytes that arrive in pieces.
class Sha256 {
 public:
  void update(std::span<const std::byte> bytes);

  /// The digest of everything passed to `update`. Call once, last.
  std::array<std::uint8_t, 32> finish();

 private:
  static constexpr std::size_t block_size = 64;

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::byte, block_size> pending_{};  // bytes that do not fill a block yet
  std::size_t pending_size_ = 0;
  std::uint64_t total_size_ = 0;  // bytes
};

/// The SHA-256 of `bytes` as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace uhas
