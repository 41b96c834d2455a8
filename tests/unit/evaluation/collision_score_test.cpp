#include <doctest/doctest.h>

#include "support/slider_profile.hpp"
#include "uhas/evaluation/evaluation.hpp"

using namespace uhas;

namespace {

/// A cube of 1.5 m about `center`.
TriangleMesh cube(Vector3d center) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(center + 0.75 * Vector3d{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0});
  for (const std::array<int, 4>& side :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.triangles.push_back({static_cast<std::uint32_t>(side[0]), static_cast<std::uint32_t>(side[1]),
                              static_cast<std::uint32_t>(side[2])});
    mesh.triangles.push_back({static_cast<std::uint32_t>(side[0]), static_cast<std::uint32_t>(side[2]),
                              static_cast<std::uint32_t>(side[3])});
  }
  return mesh;
}

}  // namespace

TEST_CASE("two cubes on slides meet when both have come in by their gap") {
  const HandProfile profile = test::slider_profile();
  // from 0.25 on either side of the centre outward: 0.5 m apart at rest
  const HandGeometry geometry{.links = {TriangleMesh{}, cube({1, 0, 0}), cube({-1, 0, 0})}};
  const EvaluationOptions options{.battery = {.actions = 300, .radial_bound = 0.6, .seed = 9}, .smoothness_lines = 0};
  const Evaluation evaluation = evaluate_hand(profile, &geometry, options);
  std::vector<double> distances;
  int touching = 0;
  for (const std::vector<double>& action : random_battery(profile, options.battery)) {
    double distance = 0.5;
    for (int f = 0; f < 2; ++f) {
      const auto [near, far] = test::asked_of(action, f);
      distance += std::clamp((near + far) / 2, -0.5, 0.5);
    }
    touching += distance <= 0;
    distances.push_back(std::max(distance, 0.0));
  }
  REQUIRE(touching > 0);
  REQUIRE(evaluation.collision.has_value());
  CHECK(evaluation.collision->share == doctest::Approx(touching / 300.0));
  CHECK_FALSE(evaluation.collision->at_rest);
  CHECK(evaluation.collision->distance.median == doctest::Approx(quantiles(distances).median).epsilon(1e-3));
  CHECK(evaluation.collision->least_distance == 0);
  REQUIRE(evaluation.collision->pairs.size() == 1);
  CHECK(static_cast<int>(evaluation.collision->pairs[0].poses) == touching);
  CHECK(evaluation.time.median > 0);
  CHECK(evaluation.time.p99 >= evaluation.time.median);
}

TEST_CASE("without geometry nothing is said of collisions, and numbers out of range are refused") {
  const HandProfile profile = test::slider_profile();
  CHECK_FALSE(
      evaluate_hand(profile, nullptr, {.battery = {.actions = 5}, .smoothness_lines = 0}).collision.has_value());
  CHECK_THROWS_AS(evaluate_hand(profile, nullptr, {.battery = {.actions = 0}}), Error);
  CHECK_THROWS_AS(evaluate_hand(profile, nullptr, {.threads = 0}), Error);
}
