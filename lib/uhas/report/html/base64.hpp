// Binary data as text (RFC 4648, with padding).
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace uhas {

std::string base64(std::span<const std::byte> bytes);

/// The little-endian bytes of numbers of four bytes.
template <class Number>
std::string base64_of_numbers(const std::vector<Number>& numbers) {
  static_assert(sizeof(Number) == 4);
  std::vector<std::byte> bytes;
  bytes.reserve(4 * numbers.size());
  for (const Number number : numbers)
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<std::byte>(std::bit_cast<std::uint32_t>(number) >> shift));
  return base64(bytes);
}

}  // namespace uhas
