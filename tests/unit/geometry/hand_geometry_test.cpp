#include "uhas/geometry/hand_geometry.hpp"

#include <doctest/doctest.h>

#include "support/error_check.hpp"
#include "support/toy_hand.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("each link of a profile gets the mesh of the model's link of that name") {
  HandModel model = make_toy_hand();
  HandProfile profile;
  for (auto link = model.links.rbegin(); link != model.links.rend(); ++link)
    profile.links.push_back({link->name, -1, {}});

  const HandGeometry geometry = hand_geometry(profile, model, "hand.urdf");
  REQUIRE(geometry.links.size() == model.links.size());
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const TriangleMesh& expected = model.links[model.links.size() - 1 - i].mesh;
    CHECK(geometry.links[i].vertices == expected.vertices);
    CHECK(geometry.links[i].triangles == expected.triangles);
    triangles += expected.triangles.size();
  }
  CHECK(triangles > 0);
  CHECK(triangle_count(geometry) == triangles);
}

TEST_CASE("a model without a link of the profile is refused") {
  HandProfile profile;
  profile.links = {{"no such link", -1, {}}};
  check_error(ErrorCode::invalid_model, "hand.urdf: has no link no such link",
              [&] { hand_geometry(profile, make_toy_hand(), "hand.urdf"); });
}
