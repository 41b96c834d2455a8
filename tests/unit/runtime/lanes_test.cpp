// Lanes against plain numbers, and their sine, cosine and arc tangent against libm in long double.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "uhas/runtime/lanes/lane_math.hpp"
#include "unit/runtime/lane_functions_kernel.hpp"

using namespace uhas;
using test::LaneFunctions;

namespace {

template <class Real>
std::vector<LaneFunctions<Real>> available_functions() {
  std::vector<LaneFunctions<Real>> all{test::LaneLoops<Real>::functions(), test::lane_functions_baseline<Real>()};
#ifdef UHAS_HAS_AVX2_SOURCES
  if (is_available(InstructionSet::avx2)) all.push_back(test::lane_functions_avx2<Real>());
#endif
  return all;
}

template <class Real>
std::vector<Real> random_numbers(std::mt19937_64& random, double bound, std::size_t count) {
  std::uniform_real_distribution<double> uniform(-bound, bound);
  std::vector<Real> numbers(count);
  for (Real& number : numbers) number = static_cast<Real>(uniform(random));
  return numbers;
}

/// Largest error of sine or cosine over random angles within `bound` and the multiples of pi/4 there.
template <class Real>
double sincos_error(const LaneFunctions<Real>& functions, double bound) {
  std::mt19937_64 random(1);
  std::vector<Real> x = random_numbers<Real>(random, bound, 400'000);
  for (int k = -160; k < 160; ++k) x[k + 160] = static_cast<Real>(std::clamp(k * std::numbers::pi / 4, -bound, bound));
  std::vector<Real> sine(x.size()), cosine(x.size());
  functions.sincos(x.data(), int(x.size()), sine.data(), cosine.data());
  double error = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double exact = x[i];
    error =
        std::max({error, double(std::abs(sine[i] - std::sin(exact))), double(std::abs(cosine[i] - std::cos(exact)))});
  }
  return error;
}

/// Largest error of the arc tangent over random points of all lengths, axes and diagonals included.
template <class Real>
double atan2_error(const LaneFunctions<Real>& functions) {
  std::mt19937_64 random(2);
  std::vector<Real> y = random_numbers<Real>(random, 1, 400'000), x = random_numbers<Real>(random, 1, y.size());
  for (std::size_t i = 0; i < 20'000; ++i) {
    const Real scale = std::ldexp(Real(1), int(i % 61) - 30);
    y[i] *= scale, x[i] *= i % 7 == 0 ? Real(1) : scale;
  }
  for (int i = 0; i < 9; ++i) y[i] = Real(i / 3 - 1), x[i] = Real(i % 3 - 1);
  std::vector<Real> angle(x.size());
  functions.atan2(y.data(), x.data(), int(x.size()), angle.data());
  double error = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    error = std::max(error, double(std::abs(angle[i] - std::atan2((long double)(y[i]), (long double)(x[i])))));
  return error;
}

}  // namespace

TEST_CASE_TEMPLATE("every operation of lanes is that of plain numbers, lane by lane", Real, float, double) {
  for (const LaneFunctions<Real>& functions : available_functions<Real>()) {
    CAPTURE(functions.width);
    std::mt19937_64 random(3);
    constexpr std::size_t kCount = 4096;
    std::vector<Real> a = random_numbers<Real>(random, 2, kCount), b = random_numbers<Real>(random, 2, kCount);
    for (std::size_t i = 0; i < 64; ++i) b[i] = a[i];                   // equal
    for (std::size_t i = 64; i < 96; ++i) a[i] = std::abs(a[i]) + 3;    // all above
    for (std::size_t i = 96; i < 128; ++i) a[i] = -std::abs(a[i]) - 3;  // all below
    std::array<std::vector<Real>, test::kLaneOperations> results;
    std::array<Real*, test::kLaneOperations> out;
    for (int k = 0; k < test::kLaneOperations; ++k) results[k].resize(kCount), out[k] = results[k].data();
    functions.operations(a.data(), b.data(), kCount, out.data());

    const auto check = [&](int k, auto expected) {
      for (std::size_t i = 0; i < kCount; ++i) {
        CAPTURE(k);
        CAPTURE(a[i]);
        CAPTURE(b[i]);
        REQUIRE(results[k][i] == doctest::Approx(double(expected(a[i], b[i]))).epsilon(1e-6));
      }
    };
    check(0, [](Real x, Real y) { return x + y; });
    check(1, [](Real x, Real y) { return x - y; });
    check(2, [](Real x, Real y) { return x * y; });
    check(3, [](Real x, Real y) { return x / y; });
    check(4, [](Real x, Real) { return -x; });
    check(5, [](Real x, Real y) { return std::min(x, y); });
    check(6, [](Real x, Real y) { return std::max(x, y); });
    check(7, [](Real x, Real y) { return std::min(std::max(x, Real(0)), y); });
    check(8, [](Real x, Real) { return std::abs(x); });
    check(9, [](Real x, Real) { return std::sqrt(std::abs(x)); });
    check(10, [](Real x, Real y) { return x < y ? x : Real(7); });
    check(11, [](Real x, Real y) { return x <= y && x != y ? x : Real(7); });
    check(12, [](Real x, Real y) { return x > y ? x : Real(7); });
    for (std::size_t i = 0; i < kCount; i += functions.width) {
      double total = 0;
      bool some = false, every = true;
      for (int k = 0; k < functions.width; ++k) {
        const bool above = a[i + k] >= b[i + k];
        total += a[i + k], some |= above, every &= above;
      }
      REQUIRE(results[13][i] == doctest::Approx(total).epsilon(1e-5));
      REQUIRE(results[14][i] == Real(some));
      REQUIRE(results[15][i] == Real(every));
    }
  }
}

TEST_CASE("sine and cosine err by no more than their page says") {
  for (const LaneFunctions<float>& functions : available_functions<float>()) {
    CAPTURE(functions.width);
    CHECK(sincos_error(functions, 10) <= 1.2e-7);
    CHECK(sincos_error(functions, 1000) <= 1.3e-7);
  }
  for (const LaneFunctions<double>& functions : available_functions<double>()) {
    CAPTURE(functions.width);
    CHECK(sincos_error(functions, 10) <= 2.3e-16);
    CHECK(sincos_error(functions, 1000) <= 2.3e-16);
  }
}

TEST_CASE("the arc tangent errs by no more than its page says") {
  for (const LaneFunctions<float>& functions : available_functions<float>()) {
    CAPTURE(functions.width);
    CHECK(atan2_error(functions) <= 3e-7);
  }
  for (const LaneFunctions<double>& functions : available_functions<double>()) {
    CAPTURE(functions.width);
    CHECK(atan2_error(functions) <= 4.5e-16);
  }
}

TEST_CASE("the angle of the zero vector is zero") {
  CHECK(uhas::atan2(0.0, 0.0) == 0.0);
  CHECK(uhas::atan2(0.0f, 0.0f) == 0.0f);
}

TEST_CASE("the environment holds the instruction set down") {
  const char* before = std::getenv("UHAS_INSTRUCTION_SET");
  const std::string kept = before ? before : "";
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline}) {
    setenv("UHAS_INSTRUCTION_SET", to_string(set), 1);
    CHECK(widest_instruction_set() == set);
  }
  setenv("UHAS_INSTRUCTION_SET", "no such thing", 1);
  CHECK(is_available(widest_instruction_set()));
  CHECK(std::string(to_string(InstructionSet::avx2)) == "avx2");
  CHECK(widest_instruction_set() != InstructionSet::scalar);
  before ? setenv("UHAS_INSTRUCTION_SET", kept.c_str(), 1) : unsetenv("UHAS_INSTRUCTION_SET");
}
