#include <doctest/doctest.h>

#include <vector>

#include "uhas/runtime/lateral_lookup.hpp"

using namespace uhas;

TEST_CASE("look-up is linear between knots and held at the bounds") {
  const std::vector<double> inverse{-0.4, -0.3, 0.1, 0.5, 1.1};  // m = 2
  const auto at = [&](double delta) { return look_up_lateral<double>(inverse, -0.2, 0.6, delta); };
  CHECK(at(0) == 0.1);
  CHECK(at(-0.1) == doctest::Approx(-0.3));
  CHECK(at(-0.05) == doctest::Approx(-0.1));
  CHECK(at(0.3) == doctest::Approx(0.5));
  CHECK(at(0.45) == doctest::Approx(0.8));
  CHECK(at(-7) == doctest::Approx(-0.4));
  CHECK(at(7) == doctest::Approx(1.1));
}

TEST_CASE("a side without room stays at neutral") {
  const std::vector<double> inverse{0.1, 0.1, 0.1, 0.5, 1.1};
  CHECK(look_up_lateral<double>(inverse, 0, 0.6, -0.3) == 0.1);
}

TEST_CASE("the way back inverts the look-up, for tables that rise and tables that fall") {
  for (const std::vector<double>& inverse : {std::vector<double>{-0.4, -0.3, 0.1, 0.5, 1.1}, {1.1, 0.5, 0.1, -0.3, -0.4}}) {
    for (double delta = -0.2; delta <= 0.6; delta += 0.01) {
      const double q = look_up_lateral<double>(inverse, -0.2, 0.6, delta);
      CHECK(look_up_delta_theta<double>(inverse, -0.2, 0.6, q) == doctest::Approx(delta).epsilon(1e-12));
    }
    const bool rises = inverse.front() < inverse.back();
    CHECK(look_up_delta_theta<double>(inverse, -0.2, 0.6, -9) == doctest::Approx(rises ? -0.2 : 0.6));
    CHECK(look_up_delta_theta<double>(inverse, -0.2, 0.6, 9) == doctest::Approx(rises ? 0.6 : -0.2));
  }
  CHECK(look_up_delta_theta<double>(std::vector<double>{0.1, 0.1, 0.1, 0.5, 1.1}, 0, 0.6, 0.1) == 0.0);
}
