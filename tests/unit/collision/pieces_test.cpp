#include "uhas/collision/surfaces/pieces.hpp"

#include <doctest/doctest.h>

#include "support/sliding_boxes.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("a piece is what triangles join, also where each has corners of its own") {
  const TriangleMesh one = make_box({1, 2, 3}, {2, 4, 6});
  TriangleMesh loose;  // as in an STL file
  for (const auto& triangle : one.triangles)
    for (const std::uint32_t vertex : triangle) {
      if (loose.vertices.size() % 3 == 0) {
        const auto next = static_cast<std::uint32_t>(loose.vertices.size());
        loose.triangles.push_back({next, next + 1, next + 2});
      }
      loose.vertices.push_back(one.vertices[vertex]);
    }
  for (const TriangleMesh& mesh : {one, loose}) {
    const std::vector<PieceExtremes> pieces = find_pieces(mesh);
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0][0].x == 0);
    CHECK(pieces[0][1].x == 2);
    CHECK(pieces[0][2].y == 0);
    CHECK(pieces[0][3].y == 4);
    CHECK(pieces[0][4].z == 0);
    CHECK(pieces[0][5].z == 6);
  }
  CHECK(find_pieces(merged(one, make_box({9, 0, 0}, {1, 1, 1}))).size() == 2);
}

TEST_CASE("a closed mesh winds once about what is inside, and not about what is outside or in its cavity") {
  const TriangleMesh box = make_box({}, {2, 2, 2}), cavity = turned_inside_out(make_box({}, {1, 1, 1}));
  const double exact = 1e-12;
  CHECK(winding_number(box, {0.9, -0.9, 0.9}) == doctest::Approx(1).epsilon(exact));
  CHECK(winding_number(turned_inside_out(box), {0.9, -0.9, 0.9}) == doctest::Approx(-1).epsilon(exact));
  CHECK(std::abs(winding_number(box, {1.1, 0, 0})) < exact);
  CHECK(std::abs(winding_number(merged(box, cavity), {0.4, 0, 0})) < exact);
  CHECK(winding_number(merged(box, cavity), {0.6, 0, 0}) == doctest::Approx(1).epsilon(exact));
}

TEST_CASE("a box without its lid winds five sixths about its middle") {
  TriangleMesh box = make_box({}, {2, 2, 2});
  box.triangles.resize(10);  // each face is two triangles
  CHECK(winding_number(box, {}) == doctest::Approx(5.0 / 6));
}
