#include "uhas/files/sha256.hpp"

#include <algorithm>

#include "uhas/files/sha256/blocks.hpp"

namespace uhas {
namespace {

void compress(Sha256State& state, std::span<const std::byte> blocks) {
  static const Sha256Compress own = sha256_compress_x86();
  own ? own(state, blocks) : sha256_compress_portable(state, blocks);
}

}  // namespace

void Sha256::update(std::span<const std::byte> bytes) {
  total_size_ += bytes.size();
  if (pending_size_ > 0) {
    const std::size_t taken = std::min(bytes.size(), block_size - pending_size_);
    std::copy_n(bytes.begin(), taken, pending_.begin() + pending_size_);
    pending_size_ += taken;
    bytes = bytes.subspan(taken);
    if (pending_size_ < block_size) return;
    compress(state_, pending_);
    pending_size_ = 0;
  }
  const std::size_t whole = bytes.size() - bytes.size() % block_size;
  compress(state_, bytes.first(whole));
  bytes = bytes.subspan(whole);
  std::copy(bytes.begin(), bytes.end(), pending_.begin());
  pending_size_ = bytes.size();
}

std::array<std::uint8_t, 32> Sha256::finish() {
  // padding: a one bit, zeros, and the length in bits as the last eight bytes of a block
  const std::uint64_t bits = 8 * total_size_;
  const std::size_t zeros = (2 * block_size - 9 - pending_size_) % block_size;
  std::array<std::byte, 2 * block_size> padding{std::byte{0x80}};
  for (std::size_t i = 0; i < 8; ++i) padding[1 + zeros + i] = static_cast<std::byte>(bits >> (56 - 8 * i));
  update(std::span(padding).first(1 + zeros + 8));

  std::array<std::uint8_t, 32> digest;
  for (std::size_t i = 0; i < digest.size(); ++i)
    digest[i] = static_cast<std::uint8_t>(state_[i / 4] >> (24 - 8 * (i % 4)));
  return digest;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
  constexpr char digits[] = "0123456789abcdef";
  Sha256 hash;
  hash.update(bytes);
  std::string hex;
  for (const std::uint8_t byte : hash.finish()) hex += {digits[byte >> 4], digits[byte & 15]};
  return hex;
}

}  // namespace uhas
