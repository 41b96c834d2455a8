#include "uhas/runtime/cascade/action_decoder.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "support/small_profile.hpp"

using namespace uhas;

namespace {

std::array<PlaneDeformation<double>, 2> decode(const Action<double>& action, Status expected = Status::ok) {
  std::array<PlaneDeformation<double>, 2> planes;
  const ActionDecoder<double> decoder(test::small_profile());
  CHECK(decoder.check(action) == expected);
  if (expected != Status::ok) return planes;
  const ActionNumbers<double> numbers{.values = action.values.data(),
                                      .phi = action.driving_vectors_phi.data(),
                                      .vectors = decoder.vectors_of(action.values.size()),
                                      .angles = static_cast<int>(action.driving_vectors_phi.size()),
                                      .normalized = action.normalized};
  decoder.decode(numbers, planes.data());
  return planes;
}

}  // namespace

TEST_CASE("shared slots are averaged, after each has been clamped") {
  std::vector<double> values(15, 0.0);
  values[0] = 100;                // the small profile's index owns slots 0 to 3
  values[5] = -9, values[6] = 1;  // slot 0's driving vectors
  values[13] = 0.25;              // the thumb's first
  const auto planes = decode({.values = values});
  CHECK(planes[0].delta_theta == doctest::Approx(test::small_lateral_table().delta_theta_upper / 4));
  CHECK(planes[0].delta_r[0] == doctest::Approx(-0.5));
  CHECK(planes[0].delta_r[1] == doctest::Approx(0.25));
  CHECK(planes[1].delta_theta == 0.0);
  CHECK(planes[1].delta_r[0] == doctest::Approx(0.25));
}

TEST_CASE("the normalised form maps piecewise linearly to the bounds") {
  const LateralTable table = test::small_lateral_table();
  for (double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    std::vector<double> values(15, x);
    const auto planes = decode({.values = values, .normalized = true});
    CHECK(planes[0].delta_theta == doctest::Approx(x < 0 ? -x * table.delta_theta_lower : x * table.delta_theta_upper));
    CHECK(planes[0].delta_r[0] == doctest::Approx(2 * x));
  }
}

TEST_CASE("driving vectors stand at pi j / (V + 1) unless a call places them") {
  const double pi = std::numbers::pi;
  const std::vector<double> zeros(20, 0.0);
  const auto planes = decode({.values = zeros});
  CHECK(planes[0].vectors == 3);
  for (int j = 0; j < 3; ++j) CHECK(planes[0].phi[j] == doctest::Approx(pi * (j + 1) / 4));

  const std::vector<double> own{0.5, 1.0, 2.5};
  CHECK(decode({.values = zeros, .driving_vectors_phi = own})[1].phi[2] == doctest::Approx(2.5));
}

TEST_CASE("what cannot be decoded is refused by a status") {
  const std::vector<double> zeros(15, 0.0), short_one(14, 0.0), too_many(30, 0.0);
  decode({.values = short_one}, Status::wrong_size);
  decode({.values = too_many}, Status::wrong_size);
  decode({.values = {}}, Status::wrong_size);
  std::vector<double> nan = zeros;
  nan[3] = std::numeric_limits<double>::quiet_NaN();
  decode({.values = nan}, Status::non_finite_input);
  for (const std::vector<double>& phi : {std::vector<double>{1.0, 1.0}, {2.0, 1.0}, {0.0, 1.0}, {1.0, 3.2}, {1.0, NAN}})
    decode({.values = zeros, .driving_vectors_phi = phi}, Status::invalid_driving_vectors);
  const std::vector<double> one{1.0};
  decode({.values = zeros, .driving_vectors_phi = one}, Status::wrong_size);
}

TEST_CASE("the radial profile is anchored at the pole, linear between driving vectors, constant beyond the last") {
  PlaneDeformation<double> plane;
  plane.vectors = 2;
  plane.phi = {1.0, 2.0};
  plane.delta_r = {0.4, -0.6};
  plane.complete(false, false);
  const auto at = [&](double phi) { return plane.at(phi).delta_r; };
  CHECK(at(0) == doctest::Approx(0));
  CHECK(at(0.5) == doctest::Approx(0.2));
  CHECK(at(1.0) == doctest::Approx(0.4));
  CHECK(at(1.5) == doctest::Approx(-0.1));
  CHECK(at(2.0) == doctest::Approx(-0.6));
  CHECK(at(3.1) == -0.6);
  CHECK(plane.at(0.5).past_first == doctest::Approx(0.4));
  CHECK(plane.at(1.5).past_first == plane.at(1.5).delta_r);
}
