#include "uhas/kinematics/lateral_lookup.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

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

TEST_CASE("the bounds give the ends of the table bit for bit, and no value lies beyond them") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-2, 2);
  const auto check = [&]<class Real>(Real) {
    for (int n = 0; n < 2000; ++n) {
      std::vector<Real> inverse(9);
      for (Real& q : inverse) q = static_cast<Real>(value(random));
      std::ranges::sort(inverse);
      if (n % 2 == 1) std::ranges::reverse(inverse);
      const auto [least, most] = std::ranges::minmax(inverse);
      const Real lower = -static_cast<Real>(std::abs(value(random))),
                 upper = static_cast<Real>(std::abs(value(random)));
      const auto at = [&](Real delta) { return look_up_lateral<Real>(inverse, lower, upper, delta); };
      CHECK(at(lower) == inverse.front());
      CHECK(at(upper) == inverse.back());
      for (int i = 0; i < 20; ++i) {
        const Real q = at(static_cast<Real>(value(random)));
        CHECK((q >= least && q <= most));
      }
    }
  };
  check(double{});
  check(float{});
}

TEST_CASE("a side without room stays at neutral") {
  const std::vector<double> inverse{0.1, 0.1, 0.1, 0.5, 1.1};
  CHECK(look_up_lateral<double>(inverse, 0, 0.6, -0.3) == 0.1);
}

TEST_CASE("the way back inverts the look-up, for tables that rise and tables that fall") {
  for (const std::vector<double>& inverse :
       {std::vector<double>{-0.4, -0.3, 0.1, 0.5, 1.1}, {1.1, 0.5, 0.1, -0.3, -0.4}}) {
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
