// A profile survives being flat, and damaged bytes are refused or read as a sound profile: never read past.
#include "uhas/profile_io/flat_profile.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

#include "support/error_check.hpp"
#include "support/small_profile.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

std::vector<std::byte> bytes_of(const char* text) {
  const auto* first = reinterpret_cast<const std::byte*>(text);
  return {first, first + std::strlen(text)};
}

}  // namespace

TEST_CASE("every field of a profile survives being flat") {
  const HandProfile profile = small_profile();
  CHECK(unflatten_profile(flatten_profile(profile)) == profile);
}

TEST_CASE("flat bytes open with the signature and the hand's name") {
  std::vector<std::byte> expected = bytes_of("uhasflat");
  expected.insert(expected.end(), {std::byte{10}, std::byte{0}, std::byte{0}, std::byte{0}});
  const std::vector<std::byte> name = bytes_of("small hand");
  expected.insert(expected.end(), name.begin(), name.end());
  std::vector<std::byte> flat = flatten_profile(small_profile());
  flat.resize(expected.size());
  CHECK(flat == expected);
}

TEST_CASE("a flat profile that ends early is refused, wherever it ends") {
  const std::vector<std::byte> flat = flatten_profile(small_profile());
  for (std::size_t length = 0; length < flat.size(); ++length) {
    const std::vector<std::byte> cut(flat.begin(), flat.begin() + static_cast<std::ptrdiff_t>(length));
    check_error(ErrorCode::invalid_profile, "the flat hand profile is cut short", [&] { unflatten_profile(cut); });
  }
}

TEST_CASE("flat bytes that are no flat profile are refused") {
  std::vector<std::byte> flat = flatten_profile(small_profile());
  flat.push_back(std::byte{0});
  check_error(ErrorCode::invalid_profile, "has bytes beyond its end", [&] { unflatten_profile(flat); });
  check_error(ErrorCode::invalid_profile, "does not begin as one",
              [&] { unflatten_profile(bytes_of("\x89HDF\r\n\x1a\n")); });
}

TEST_CASE("a damaged byte of a flat profile is refused, or leaves a sound profile") {
  const std::vector<std::byte> flat = flatten_profile(small_profile());
  std::size_t refused = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    std::vector<std::byte> damaged = flat;
    damaged[i] ^= std::byte{0x80};
    try {
      const HandProfile profile = unflatten_profile(damaged);
      CHECK_NOTHROW(validate_profile(profile, ""));
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::invalid_profile);
      ++refused;
    }
  }
  CHECK(refused > flat.size() / 20);
}

TEST_CASE("a flat profile that is not sound is refused in the validator's words") {
  HandProfile profile = small_profile();
  profile.radius = -1;
  check_error(ErrorCode::invalid_profile, "sphere/radius", [&] { unflatten_profile(flatten_profile(profile)); });
}
