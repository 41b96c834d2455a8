#include "uhas/collision/surfaces/link_surface.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/mesh_contact.hpp"
#include "support/sliding_boxes.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kPrecision = 1e-12;  // m

/// A bumpy sheet in x and y of 2 n n triangles with edges of `edge` (m).
TriangleMesh make_sheet(int n, double edge, std::mt19937_64& random) {
  std::uniform_real_distribution<double> height(0, 0.5 * edge);
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) mesh.vertices.push_back({edge * i, edge * j, height(random)});
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

RigidTransformd random_transform(std::mt19937_64& random, double reach) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const Vector3d axis = normalized(Vector3d{unit(random), unit(random), unit(random)});
  return {Rotationd::about(axis, 3 * unit(random)), reach * Vector3d{unit(random), unit(random), unit(random)}};
}

}  // namespace

TEST_CASE("two boxes: faces, edges, corners, touching and crossing") {
  const LinkSurface box(make_box({}, {0.0625, 0.0625, 0.0625}));
  struct {
    Vector3d offset;
    double distance;
    bool in_contact;
  } const cases[] = {{{0.0625 + 0.003, 0.01, -0.02}, 0.003, false},
                     {{0.0625 + 0.003, 0.0625 + 0.004, 0}, 0.005, false},
                     {{0.0625 + 0.002, -0.0625 - 0.003, 0.0625 + 0.006}, 0.007, false},
                     {{0.0625, 0, 0}, 0, true},  // exact in binary
                     {{0.05, 0.01, 0.02}, 0, true}};
  for (const auto& c : cases) {
    CAPTURE(c.offset.x);
    CHECK(std::abs(box.distance(box, {{}, c.offset}, kNoLimit) - c.distance) < kPrecision);
    CHECK(box.in_contact(box, {{}, c.offset}) == c.in_contact);
    CHECK(box.least_possible_distance(box, {{}, c.offset}) <= c.distance + kPrecision);
  }
}

TEST_CASE("a distance that is not less than the limit is the limit") {
  const LinkSurface box(make_box({}, {0.02, 0.02, 0.02}));
  CHECK(box.distance(box, {{}, {0.05, 0, 0}}, 0.01) == 0.01);
  CHECK(std::abs(box.distance(box, {{}, {0.05, 0, 0}}, 0.04) - 0.03) < kPrecision);
}

TEST_CASE("a box inside another is in contact with it, but not a box in its cavity") {
  const TriangleMesh shell = make_box({}, {0.1, 0.1, 0.1});
  const LinkSurface large(shell), inward(turned_inside_out(shell));
  const LinkSurface hollow(merged(shell, turned_inside_out(make_box({}, {0.08, 0.08, 0.08}))));
  const LinkSurface small(make_box({}, {0.01, 0.01, 0.01}));
  const RigidTransformd T{{}, {0.02, 0, 0}};
  CHECK(large.in_contact(small, T));
  CHECK(small.in_contact(large, T.inverse()));
  CHECK(inward.in_contact(small, T));
  CHECK_FALSE(hollow.in_contact(small, T));

  const LinkSurface two_pieces(merged(make_box({-0.5, 0, 0}, {0.01, 0.01, 0.01}), make_box({}, {0.01, 0.01, 0.01})));
  CHECK(large.in_contact(two_pieces, T));
}

TEST_CASE("distances and contacts of bumpy sheets are those of all pairs of triangles") {
  std::mt19937_64 random(1);
  // in metres FCL is wrong where edges are under 0.25 mm
  for (const double edge : {4e-3, 2e-4, 3e-5}) {
    int touching = 0, apart = 0;
    for (int i = 0; i < 60; ++i) {
      const TriangleMesh a = make_sheet(5, edge, random), b = make_sheet(5, edge, random);
      const RigidTransformd T = random_transform(random, 6 * edge);
      const PlacedMesh all_a(a, {}), all_b(b, T);
      double expected = kNoLimit;
      for (const BoxedTriangle& s : all_a.triangles)
        for (const BoxedTriangle& t : all_b.triangles)
          expected = std::min(expected, triangle_distance(s.corners, t.corners));
      REQUIRE(mesh_distance(all_a, all_b, 1) == expected);
      REQUIRE(meshes_cross(all_a, all_b) == (expected == 0));

      CAPTURE(edge);
      CAPTURE(i);
      const LinkSurface surface_a(a), surface_b(b);
      CHECK(std::abs(surface_a.distance(surface_b, T, kNoLimit) - expected) < kPrecision);
      CHECK(surface_a.in_contact(surface_b, T) == (expected == 0));
      CHECK(surface_a.least_possible_distance(surface_b, T) <= expected + kPrecision);
      (expected == 0 ? touching : apart) += 1;
    }
    CHECK(touching > 5);
    CHECK(apart > 5);
  }
}
