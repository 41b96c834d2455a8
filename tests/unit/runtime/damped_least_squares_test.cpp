#include "uhas/runtime/encoding/damped_least_squares.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace uhas;

TEST_CASE("with little damping the exact solution of a full system comes back") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 1; n <= 4; ++n) {
    std::array<double, 4> expected{};
    for (int i = 0; i < n; ++i) expected[i] = unit(random);
    DampedLeastSquares<4> equations(n);
    for (int row = 0; row < 3 * n; ++row) {
      std::array<double, 4> a{};
      double b = 0;
      for (int i = 0; i < n; ++i) a[i] = unit(random), b += a[i] * expected[i];
      equations.add(a, b, 0.1 + row);
    }
    const auto x = equations.solve(1e-12);
    for (int i = 0; i < n; ++i) CHECK(x[i] == doctest::Approx(expected[i]).epsilon(1e-9));
  }
}

TEST_CASE("the solution makes the gradient vanish: A' W (A x - b) + damping x = 0") {
  DampedLeastSquares<2> equations(2);
  const double rows[3][4] = {{1, 2, 3, 0.5}, {-1, 0.5, 1, 2}, {0.3, 0.1, -2, 1}};  // a_0, a_1, b, weight
  for (const auto& row : rows) equations.add(std::array{row[0], row[1]}, row[2], row[3]);
  const double damping = 0.7;
  const auto x = equations.solve(damping);
  for (int i = 0; i < 2; ++i) {
    double gradient = damping * x[i];
    for (const auto& row : rows) gradient += row[3] * row[i] * (row[0] * x[0] + row[1] * x[1] - row[2]);
    CHECK(std::abs(gradient) < 1e-14);
  }
}

TEST_CASE("an unknown that no equation names stays zero") {
  DampedLeastSquares<3> equations(3);
  equations.add(std::array{2.0, 0.0, 0.0}, 4.0, 1.0);
  const auto x = equations.solve(1e-9);
  CHECK(x[0] == doctest::Approx(2));
  CHECK(x[1] == 0.0);
  CHECK(x[2] == 0.0);
}
