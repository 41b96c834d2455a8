// Numbers that a user of a test may choose.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace uhas::test {

/// The number in the environment variable `name`; without it, `otherwise`.
inline std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace uhas::test
