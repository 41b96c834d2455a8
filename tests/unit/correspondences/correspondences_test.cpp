#include "uhas/correspondences/correspondences.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toy_hand.hpp"
#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

using test::box;
using test::inside_out;
using test::plate;
using test::project;
using test::toy_hand;
using test::ToyHand;

constexpr double kAngle = 0.3;  // azimuth of the toy finger

bool same_bytes(const Correspondence& a, const Correspondence& b) {
  return a.link == b.link && a.p_link == b.p_link && a.normal_link == b.normal_link && a.theta == b.theta &&
         a.phi == b.phi && a.rho == b.rho && a.weight == b.weight;
}

void check_same_sphere_points(const Correspondences& a, const Correspondences& b, double tolerance) {
  REQUIRE(a.points.size() == b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    CHECK(a.points[i].link == b.points[i].link);
    CHECK(std::abs(a.points[i].theta - b.points[i].theta) <= tolerance);
    CHECK(std::abs(a.points[i].phi - b.points[i].phi) <= tolerance);
    CHECK(std::abs(a.points[i].rho - b.points[i].rho) <= tolerance);
    CHECK(std::abs(a.points[i].weight - b.points[i].weight) <= tolerance);
  }
}

/// Number of the Fibonacci directions that pass the plate of half sizes `half_y`, `half_z` at distance 0.1
/// and azimuth kAngle.
int directions_through_plate(int samples, double half_y, double half_z) {
  int count = 0;
  for (int i = 0; i < samples; ++i) {
    const double z = -1 + (2 * i + 1) / static_cast<double>(samples);
    const double azimuth = std::fmod(i * std::numbers::pi * (std::sqrt(5.0) - 1), 2 * std::numbers::pi) - kAngle;
    const double x = std::sqrt(1 - z * z) * std::cos(azimuth), y = std::sqrt(1 - z * z) * std::sin(azimuth);
    if (x > 0 && std::abs(0.1 * y / x) <= half_y && std::abs(0.1 * z / x) <= half_z) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("the points of a plate are where geometry says") {
  const ToyHand hand = toy_hand({}, plate(0, 0.02, 0.03));
  const Correspondences found = project(hand);
  CHECK(found.warnings.empty());
  CHECK(found.hits[0].kept == 0);
  CHECK(found.hits[1].kept == directions_through_plate(20000, 0.02, 0.03));
  CHECK(found.hits[1].too_far == 0);
  CHECK(found.hits[1].facing_away == 0);
  REQUIRE(found.points.size() == static_cast<std::size_t>(found.hits[1].kept));
  REQUIRE(found.points.size() > 100);
  for (const Correspondence& point : found.points) {
    const auto [x, y, z] = point.p_link;
    const double distance = std::hypot(0.1, y, z);  // the link's origin is 0.1 from the centre
    CHECK(point.link == 1);
    CHECK(std::abs(x) < 1e-15);
    CHECK(std::abs(y) <= 0.02);
    CHECK(std::abs(z) <= 0.03);
    CHECK(point.normal_link == Vector3d{-1, 0, 0});
    CHECK(point.theta == doctest::Approx(kAngle + std::atan2(y, 0.1)).epsilon(1e-12));
    CHECK(point.phi == doctest::Approx(std::acos(-z / distance)).epsilon(1e-12));
    CHECK(point.rho == doctest::Approx(distance / 0.1).epsilon(1e-12));
  }
}

TEST_CASE("only the face of a box that faces the centre has points, whichever way its triangles are wound") {
  const TriangleMesh solid = box({0.01, 0.02, 0.02}, {0.01, 0, 0});
  for (const TriangleMesh& mesh : {solid, inside_out(solid)}) {
    const Correspondences found = project(toy_hand({}, mesh));
    CHECK(found.hits[1].kept == directions_through_plate(20000, 0.02, 0.02));
    CHECK(found.hits[1].facing_away == 0);
    for (const Correspondence& point : found.points) {
      CHECK(std::abs(point.p_link.x) < 1e-15);
      CHECK(point.normal_link == Vector3d{-1, 0, 0});
    }
  }
}

TEST_CASE("a plate that faces away has no points, and a warning says so") {
  const Correspondences found = project(toy_hand({}, inside_out(plate(0, 0.02, 0.02))));
  CHECK(found.points.empty());
  CHECK(found.hits[1].facing_away == directions_through_plate(20000, 0.02, 0.02));
  REQUIRE(found.warnings.size() == 1);
  CHECK(found.warnings[0].find("'finger'") != std::string::npos);
  CHECK(found.warnings[0].find("0 rays from the sphere's centre met it too far from the sphere, " +
                               std::to_string(found.hits[1].facing_away) + " from behind") != std::string::npos);
}

TEST_CASE("hits beyond the bound on the radius are dropped and counted") {
  const ToyHand hand = toy_hand({}, plate(0, 0.02, 0.02));
  const int all = directions_through_plate(20000, 0.02, 0.02);

  CorrespondenceOptions near;
  near.max_radius_deviation = 0.01;  // the plate's corners are at 1.04 radii
  const Correspondences some = project(hand, near);
  CHECK(some.hits[1].kept > 0);
  CHECK(some.hits[1].too_far > 0);
  CHECK(some.hits[1].kept + some.hits[1].too_far == all);
  for (const Correspondence& point : some.points) CHECK(std::abs(point.rho - 1) <= 0.01);

  const Correspondences none = project(toy_hand({}, plate(0.06, 0.02, 0.02)));
  CHECK(none.points.empty());
  CHECK(none.hits[1].too_far > 0);
  CHECK(none.warnings.size() == 1);
}

TEST_CASE("the nearer of two plates hides the other, whichever link has it") {
  TriangleMesh two = plate(0, 0.02, 0.02);
  const TriangleMesh near = plate(-0.01, 0.02, 0.02);
  for (const auto& triangle : near.triangles)
    two.triangles.push_back({triangle[0] + 4, triangle[1] + 4, triangle[2] + 4});
  two.vertices.insert(two.vertices.end(), near.vertices.begin(), near.vertices.end());
  const Correspondences one_link = project(toy_hand({}, two));
  REQUIRE(one_link.points.size() > 100);
  for (const Correspondence& point : one_link.points) CHECK(point.p_link.x == doctest::Approx(-0.01));

  // a palm wall across the finger's azimuth, nearer than the finger and wider
  ToyHand hand = toy_hand(plate(0.05, 0.1, 0.1), plate(0, 0.02, 0.02));
  for (Vector3d& vertex : hand.model.links[0].mesh.vertices) vertex.z += 0.1;
  const Correspondences two_links = project(hand);
  CHECK(two_links.hits[0].kept > 0);
  CHECK(two_links.hits[1].kept == 0);
}

TEST_CASE("points are sorted by link, only those of links that joints carry have weights, and these sum to 1") {
  const Correspondences found = project(toy_hand(box({0.05, 0.05, 0.01}, {}), plate(0, 0.02, 0.02)));
  CHECK(found.hits[0].kept > 0);
  CHECK(found.hits[1].kept > 0);
  CHECK(std::ranges::is_sorted(found.points, {}, &Correspondence::link));
  double sum = 0;
  int weighted = 0;
  for (const Correspondence& point : found.points) {
    if (point.link == 0) CHECK(point.weight == 0);
    CHECK(point.weight >= 0);
    sum += point.weight;
    weighted += point.weight > 0;
  }
  CHECK(weighted == 32);
  CHECK(sum == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("a hand that is neither right nor left has the points of its mirror image, mirrored") {
  ToyHand hand = toy_hand({}, box({0.01, 0.02, 0.02}, {0.003, 0.007, 0.01})), image = test::mirrored(hand);
  hand.anatomy.handedness = image.anatomy.handedness = Handedness::none;
  image.frame.mirrored = false;
  const Correspondences a = project(hand), b = project(image);
  REQUIRE(a.points.size() > 100);
  REQUIRE(a.points.size() == b.points.size());
  for (const Correspondence& point : a.points)
    CHECK(std::ranges::any_of(b.points, [&](const Correspondence& other) {
      return std::abs(other.theta + point.theta) < 1e-12 && std::abs(other.phi - point.phi) < 1e-12;
    }));
}

TEST_CASE("a mirrored hand has mirrored points, bit for bit") {
  const ToyHand right =
      toy_hand(box({0.05, 0.04, 0.01}, {0.01, 0.02, 0}), box({0.01, 0.02, 0.02}, {0.003, 0.007, 0.01}));
  const ToyHand left = test::mirrored(right);
  const Correspondences a = project(right), b = project(left);
  REQUIRE(a.points.size() > 1000);
  check_same_sphere_points(a, b, 0);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    CHECK(a.points[i].p_link == Vector3d{b.points[i].p_link.x, -b.points[i].p_link.y, b.points[i].p_link.z});
    CHECK(a.points[i].normal_link ==
          Vector3d{b.points[i].normal_link.x, -b.points[i].normal_link.y, b.points[i].normal_link.z});
  }
  // wound as an exporter would wind the left hand: the sums run over the corners in another order
  ToyHand rewound = left;
  for (ModelLink& link : rewound.model.links) link.mesh = inside_out(link.mesh);
  check_same_sphere_points(a, project(rewound), 1e-12);
}

TEST_CASE("azimuth, polar angle and rest radius do not depend on the size of the hand") {
  const ToyHand hand = toy_hand(box({0.05, 0.04, 0.01}, {0.01, 0.02, 0}), box({0.01, 0.02, 0.02}, {0.01, 0.005, 0.01}));
  const Correspondences original = project(hand);
  REQUIRE(original.points.size() > 1000);
  for (const double factor : {0.001, 0.37, 2.5, 1000.0})
    check_same_sphere_points(original, project(test::scaled(hand, factor)), 1e-9);
}

TEST_CASE("the same input gives the same bytes") {
  const ToyHand hand = toy_hand(box({0.05, 0.05, 0.01}, {}), box({0.01, 0.02, 0.02}, {0.01, 0, 0}));
  const Correspondences a = project(hand), b = project(hand);
  CHECK(std::ranges::equal(a.points, b.points, same_bytes));
}

TEST_CASE("azimuth lies in (-pi, pi]") {
  ToyHand hand = toy_hand({}, plate(0, 0.05, 0.05));
  hand.q = {std::numbers::pi};
  const Correspondences found = project(hand);
  REQUIRE(!found.points.empty());
  for (const Correspondence& point : found.points) {
    CHECK(point.theta > -std::numbers::pi);
    CHECK(point.theta <= std::numbers::pi);
  }
}

TEST_CASE("a hand without meshes and options without sense are refused") {
  CHECK_THROWS_WITH_AS(project(toy_hand({}, {})),
                       "no link of the hand has a mesh; add <visual> or <collision> geometry to its links", Error);
  const ToyHand hand = toy_hand({}, plate(0, 0.02, 0.02));
  CorrespondenceOptions options;
  options.samples = 0;
  CHECK_THROWS_AS(project(hand, options), Error);
  options = {};
  options.points_per_link = 0;
  CHECK_THROWS_AS(project(hand, options), Error);
  options = {};
  options.max_radius_deviation = std::nan("");
  CHECK_THROWS_AS(project(hand, options), Error);
}

}  // namespace uhas
