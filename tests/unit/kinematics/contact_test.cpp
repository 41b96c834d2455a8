// First contact against a fine brute-force scan.
#include "uhas/kinematics/contact.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace uhas;

namespace {

struct Case {
  Circle<double> circle;
  JointTravel<double> travel;
};

Case random_case(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector3d{unit(random), unit(random), unit(random)}; };
  Case c;
  c.circle = Circle<double>::about(normalized(vector()), 1.2 * vector(), 1.5 * vector());
  c.travel.open = 0.3 * unit(random);
  const double sign = unit(random) < 0 ? -1 : 1;
  c.travel.closed = c.travel.open + sign * (1.0 + 0.9 * unit(random));
  c.travel.opposite = c.travel.open - sign * (0.5 + 0.4 * unit(random));
  return c;
}

}  // namespace

TEST_CASE("the circle passes through the point at joint value zero and keeps its distance from the axis") {
  const Vector3d axis = normalized(Vector3d{1, 2, 3}), origin{0.1, 0.2, -0.3}, p{0.7, -0.2, 0.5};
  const Circle<double> circle = Circle<double>::about(axis, origin, p);
  CHECK(norm(circle.at(0) - p) < 1e-15);
  CHECK(norm(circle.at(0.8) - (origin + Rotationd::about(axis, 0.8) * (p - origin))) < 1e-15);
}

TEST_CASE("the closed form finds the first root a brute-force scan finds") {
  std::mt19937_64 random(1);
  int met = 0;
  for (int n = 0; n < 20000; ++n) {
    const Case c = random_case(random);
    const auto gap = [&](double t) { return norm(c.circle.at(t)) - 1; };
    const double end = gap(c.travel.open) >= 0 ? c.travel.closed : c.travel.opposite;
    double first = NAN;
    constexpr int steps = 2000;
    for (int k = 1; k <= steps && std::isnan(first); ++k) {
      const double a = c.travel.open + (end - c.travel.open) * (k - 1) / steps;
      const double b = c.travel.open + (end - c.travel.open) * k / steps;
      if ((gap(a) >= 0) != (gap(b) >= 0)) first = a;
    }
    if (std::isnan(first)) continue;
    ++met;
    CAPTURE(n);
    const double found = first_contact_with_sphere(c.circle, c.travel);
    CHECK(std::abs(gap(found)) < 1e-9);
    CHECK(std::abs(found - first) <= std::abs(end - c.travel.open) / steps + 1e-9);
  }
  CHECK(met > 2000);
}

TEST_CASE("without a meeting the least gap on the way is found") {
  std::mt19937_64 random(2);
  int missed = 0;
  for (int n = 0; n < 20000; ++n) {
    const Case c = random_case(random);
    const auto gap = [&](double t) { return norm(c.circle.at(t)) - 1; };
    const double end = gap(c.travel.open) >= 0 ? c.travel.closed : c.travel.opposite;
    double least = 1e9;
    bool meets = false;
    for (int k = 0; k <= 1000; ++k) {
      const double g = gap(c.travel.open + (end - c.travel.open) * k / 1000);
      meets = meets || (g >= 0) != (gap(c.travel.open) >= 0);
      least = std::min(least, std::abs(g));
    }
    if (meets) continue;
    ++missed;
    CAPTURE(n);
    const double found = first_contact_with_sphere(c.circle, c.travel);
    const double least_gain = found == c.travel.open ? kLeastGain<double> : 0;  // what a joint does not leave open for
    CHECK(std::abs(gap(found)) <= least + least_gain + 1e-12);
  }
  CHECK(missed > 2000);
}

TEST_CASE("the scan and the closed form agree on a sphere") {
  std::mt19937_64 random(3);
  int apart = 0;
  for (int n = 0; n < 5000; ++n) {
    const Case c = random_case(random);
    const double exact = first_contact_with_sphere(c.circle, c.travel);
    const double scanned = first_contact_by_scan<double>([&](double t) { return norm(c.circle.at(t)) - 1; }, c.travel);
    apart += std::abs(exact - scanned) > 1e-6;
  }
  CHECK(apart <= 25);  // the scan may step over two roots that lie closer than its step
}

TEST_CASE("a point already on the sphere stays") {
  const Circle<double> circle = Circle<double>::about({0, 1, 0}, {1, 0, 0.5}, {1, 0, 0});
  const double on_sphere = first_contact_with_sphere(circle, {0.4, 2.0, -1.0});
  CHECK(std::abs(first_contact_with_sphere(circle, {on_sphere, 2.0, -1.0}) - on_sphere) < 1e-9);
}
