#include "uhas/runtime/joint_groups.hpp"

#include <doctest/doctest.h>

#include "support/small_profile.hpp"

using namespace uhas;

TEST_CASE("every joint is in one group, and the reference posture is q_sphere") {
  const HandProfile profile = test::small_profile();
  CHECK(lateral_joints(profile) == std::vector<int>{0});
  CHECK(encompassing_joints(profile) == std::vector<int>{1, 2, 3, 4});
  CHECK(reference_posture(profile) == std::vector<double>{0.1, 0.7, 0.61, 0.4, 0.01});
}
