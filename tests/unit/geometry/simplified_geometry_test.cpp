#include "uhas/geometry/simplified_geometry.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace uhas;

namespace {

constexpr double kRadius = 0.02;  // m

/// A sphere of 4 n (n - 1) triangles in rings; as in an STL file, every triangle has corners of its own.
TriangleMesh make_sphere(int n) {
  const auto point = [n](int ring, int step) {
    const double phi = std::numbers::pi * ring / n, theta = std::numbers::pi * (step % (2 * n)) / n;
    return kRadius *
           Vector3d{std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), ring == n ? -1 : std::cos(phi)};
  };
  TriangleMesh mesh;
  const auto add = [&mesh](Vector3d a, Vector3d b, Vector3d c) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (int ring = 0; ring < n; ++ring) {
    for (int step = 0; step < 2 * n; ++step) {
      const Vector3d a = point(ring, step), b = point(ring + 1, step), c = point(ring + 1, step + 1),
                     d = point(ring, step + 1);
      if (ring < n - 1) add(a, b, c);
      if (ring > 0) add(a, c, d);
    }
  }
  return mesh;
}

/// Volume inside (m^3), by the divergence theorem.
double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return sum;
}

}  // namespace

TEST_CASE("a simplified sphere has the triangles asked for, keeps its surface and its volume") {
  const HandGeometry fine{{make_sphere(60), {}, make_sphere(60)}};
  REQUIRE(triangle_count(fine) == 2 * 2 * (2 * 60) * (60 - 1));

  const HandGeometry coarse = simplified_geometry(fine, 1'000);
  REQUIRE(coarse.links.size() == 3);
  CHECK(coarse.links[1].triangles.empty());
  CHECK(triangle_count(coarse) <= 1'000);
  CHECK(triangle_count(coarse) >= 300);
  for (const std::size_t link : {0, 2}) {
    const TriangleMesh& mesh = coarse.links[link];
    for (const Vector3d& p : mesh.vertices) CHECK(norm(p) == doctest::Approx(kRadius).epsilon(1e-6));
    CHECK(volume(mesh) == doctest::Approx(4.0 / 3 * std::numbers::pi * std::pow(kRadius, 3)).epsilon(0.1));
    CHECK(mesh.vertices.size() == mesh.triangles.size() / 2 + 2);  // Euler: closed, without handles, no corner twice
  }
}

TEST_CASE("what is small enough keeps its triangles") {
  const HandGeometry fine{{make_sphere(8)}};
  const HandGeometry same = simplified_geometry(fine, triangle_count(fine));
  CHECK(triangle_count(same) == triangle_count(fine));
  CHECK(volume(same.links[0]) == doctest::Approx(volume(fine.links[0])));
}

TEST_CASE("nothing stays nothing") { CHECK(triangle_count(simplified_geometry({{{}, {}}}, 0)) == 0); }
