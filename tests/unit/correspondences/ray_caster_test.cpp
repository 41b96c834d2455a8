#include "uhas/correspondences/rays/ray_caster.hpp"

#include <doctest/doctest.h>

#include "toy_hand.hpp"

namespace uhas {

TEST_CASE("a ray names the mesh and the triangle that it meets first, from either side") {
  const TriangleMesh wall = test::plate(0, 1, 1), empty;
  const PosedMesh meshes[] = {{&wall, {{}, {3, 0, 0}}}, {&empty, {}}, {&wall, {{}, {2, 0, 0}}}};
  const RayCaster caster(meshes);

  const auto forward = caster.first_hit({}, {1, 0.1, -0.2});  // below the plate's diagonal: triangle 0
  REQUIRE(forward);
  CHECK(forward->mesh == 2);
  CHECK(forward->triangle == 0);
  const auto backward = caster.first_hit({5, 0, 0}, {-1, -0.1, 0.2});
  REQUIRE(backward);
  CHECK(backward->mesh == 0);
  CHECK(backward->triangle == 1);
  CHECK(!caster.first_hit({}, {-1, 0, 0}));
}

TEST_CASE("a scene without triangles is never hit") { CHECK(!RayCaster({}).first_hit({}, {0, 0, 1})); }

}  // namespace uhas
