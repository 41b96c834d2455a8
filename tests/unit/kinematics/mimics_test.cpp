#include "uhas/kinematics/mimics.hpp"

#include <doctest/doctest.h>

#include "support/toy_tree.hpp"

using namespace uhas;

namespace {

/// Two hinges; the first one's followers stand before and behind it.
KinematicTree tree_with_followers() {
  KinematicTree tree;
  test::add_follower(tree, -1, {0, 0, 0}, {0, 0, 1}, 1, -2);
  test::add_hinge(tree, -1, {1, 0, 0}, {0, 0, 1}, -1, 1);
  test::add_follower(tree, 1, {2, 0, 0}, {0, 0, 1}, 1, 0.5);
  test::add_hinge(tree, 2, {3, 0, 0}, {0, 0, 1}, -1, 1);
  tree.joints[2].mimic_offset = 0.25;
  return tree;
}

}  // namespace

TEST_CASE("the independent joint of a follower is its master") {
  const KinematicTree tree = tree_with_followers();
  CHECK(independent_joint(tree, 0) == 1);
  CHECK(independent_joint(tree, 1) == 1);
  CHECK(independent_joint(tree, 3) == 3);
  CHECK(independent_joints(tree, std::vector<int>{3, 2, 1}) == std::vector<int>{3, 1});
}

TEST_CASE("a joint turns with itself and with its master, not with another follower") {
  const KinematicTree tree = tree_with_followers();
  CHECK(turns_with(tree, 1, 1));
  CHECK(turns_with(tree, 2, 1));
  CHECK_FALSE(turns_with(tree, 1, 2));
  CHECK_FALSE(turns_with(tree, 0, 2));
  CHECK_FALSE(turns_with(tree, 3, 1));
}

TEST_CASE("followers stand where their masters put them") {
  const KinematicTree tree = tree_with_followers();
  std::vector<double> q{9, 0.5, 9, 0.125};
  apply_mimics(tree, q);
  CHECK(q == std::vector<double>{-1, 0.5, 0.5, 0.125});
  set_with_followers(tree, 1, -0.25, q);
  CHECK(q == std::vector<double>{0.5, -0.25, 0.125, 0.125});
  set_with_followers(tree, 3, 1, q);
  CHECK(q == std::vector<double>{0.5, -0.25, 0.125, 1});
}
