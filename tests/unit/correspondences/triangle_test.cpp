#include "uhas/correspondences/rays/triangle.hpp"

#include <doctest/doctest.h>

#include "toy_hand.hpp"

namespace uhas {
namespace {

const Triangle kTriangle{Vector3d{2, 0, 0}, Vector3d{2, 0, 1}, Vector3d{2, 1, 0}};  // front toward the origin

}  // namespace

TEST_CASE("a ray meets the front of a triangle at the point geometry says") {
  const RayMeeting meeting = meet_from_origin(kTriangle, {1, 0.1, 0.2});
  CHECK(meeting.facing < 0);
  const Vector3d p = point_at(kTriangle, meeting.barycentric);
  CHECK(p.x == doctest::Approx(2));
  CHECK(p.y == doctest::Approx(0.2));
  CHECK(p.z == doctest::Approx(0.4));
  CHECK(meet_from_origin({kTriangle[0], kTriangle[2], kTriangle[1]}, {1, 0.1, 0.2}).facing > 0);
  CHECK(meet_from_origin(kTriangle, {0, 1, 0}).facing == 0);
}

TEST_CASE("a meeting beyond an edge is moved onto the triangle") {
  const RayMeeting meeting = meet_from_origin(kTriangle, {1, -1e-6, 0.2});
  const Vector3d p = point_at(kTriangle, meeting.barycentric);
  CHECK(p.y == 0);
  CHECK(p.z == doctest::Approx(0.4).epsilon(1e-5));
}

TEST_CASE("a mesh is inside out when its volume is negative, wherever it lies") {
  for (const Vector3d center : {Vector3d{}, Vector3d{5, -7, 3}}) {
    const TriangleMesh solid = test::box({0.01, 0.02, 0.03}, center);
    CHECK(!is_inside_out(solid));
    CHECK(is_inside_out(test::inside_out(solid)));
  }
}

TEST_CASE("an open shell is judged from its centroid; a plate and an empty mesh are taken at their word") {
  TriangleMesh shell = test::box({0.01, 0.02, 0.03}, {1, 0, 0});
  shell.triangles.resize(8);  // without the two faces across x
  CHECK(!is_inside_out(shell));
  CHECK(is_inside_out(test::inside_out(shell)));
  CHECK(!is_inside_out(test::plate(1, 0.1, 0.1)));
  CHECK(!is_inside_out(test::inside_out(test::plate(1, 0.1, 0.1))));
  CHECK(!is_inside_out({}));
}

}  // namespace uhas
