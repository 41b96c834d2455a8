#include "uhas/anatomy/nearest_name.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace uhas;

TEST_CASE("the nearest name begins alike, or differs in the fewest letters") {
  constexpr std::array<std::string_view, 5> keys = {"format", "palm_link", "palm_normal_in_root", "q_open", "q_closed"};
  CHECK(nearest_name("palm", keys) == "palm_link");
  CHECK(nearest_name("palm_normal", keys) == "palm_normal_in_root");
  CHECK(nearest_name("plam_link", keys) == "palm_link");
  CHECK(nearest_name("q_opened", keys) == "q_open");
  CHECK(nearest_name("", keys) == "format");
  CHECK(did_you_mean("q_close", keys) == "did you mean \"q_closed\"?");
  CHECK(did_you_mean("q_close", {}).empty());
}
