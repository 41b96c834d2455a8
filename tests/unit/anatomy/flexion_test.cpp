#include "uhas/anatomy/opening/flexion.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "toy_skeleton.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// Two hinges about y; at q = 0 the second phalanx is bent toward +x by `angle`.
FingerSkeleton add_bent_finger(KinematicTree& tree, double angle) {
  const int first = add_hinge(tree, -1, {}, kY, -1, 1.2);
  const int second = add_hinge(tree, first, 0.05 * kZ, kY, -1, 1.2);
  return {{first, second}, 0.04 * Vector3d{std::sin(angle), 0, std::cos(angle)}};
}

}  // namespace

TEST_CASE("flexion joints: the parallel ones that turn the tip most, whatever side and roll joints do") {
  for (const Vector3d before : {kX, kZ}) {
    KinematicTree tree;
    const FingerSkeleton finger = add_hinges_behind(tree, before, {-1.5, 1.5}, {});
    const FlexionJoints flexion = find_flexion_joints(tree, finger);
    CHECK(flexion.positions == std::vector<int>{1, 2, 3});
    CHECK_FALSE(flexion.sliding);
    CHECK(norm(flexion_origin(tree, finger, flexion)) < 1e-12);
  }
}

TEST_CASE("flexion joints: one wide joint rather than two narrow ones") {
  KinematicTree tree;
  const int wide = add_hinge(tree, -1, {}, kX, 0, 1.5);
  const FingerSkeleton narrow = add_hinges(tree, wide, 0.01 * kZ, {-0.3, 0.3}, kZ, kY, {0.05, 0.03});
  const FingerSkeleton finger{{wide, narrow.joints[0], narrow.joints[1]}, narrow.p_tip_joint};
  CHECK(find_flexion_joints(tree, finger).positions == std::vector<int>{0});
}

TEST_CASE("flexion joints: a finger that ends in a slide is a jaw") {
  KinematicTree tree;
  const int hinge = add_hinge(tree, -1, {}, kY, 0, 1);
  const int slide = add_slide(tree, hinge, 0.05 * kZ, kY, 0, 0.04);
  const FlexionJoints flexion = find_flexion_joints(tree, {{hinge, slide}, 0.05 * kZ});
  CHECK(flexion.positions == std::vector<int>{1});
  CHECK(flexion.sliding);
}

TEST_CASE("a follower that turns backward has a negative rate") {
  KinematicTree tree;
  const int master = add_hinge(tree, -1, {}, kY, 0, 1);
  const int follower = add_follower(tree, master, 0.05 * kZ, kY, master, -0.5);
  const FingerSkeleton finger{{master, follower}, 0.05 * kZ};
  const FingerPose pose = pose_finger(tree, finger, std::vector<double>{0, 0});
  CHECK(flexion_rate(tree, finger, pose, 0, 1) == 1);
  CHECK(flexion_rate(tree, finger, pose, 1, 1) == -0.5);
}

TEST_CASE("a finger is straightened where its tip is farthest out") {
  KinematicTree tree;
  const FingerSkeleton finger = add_bent_finger(tree, 0.5);
  std::vector<double> q{0.3, 0.3};
  CHECK(straighten(tree, finger, find_flexion_joints(tree, finger), q) == std::vector<int>{1});
  CHECK(q[0] == 0.3);
  CHECK(std::abs(q[1] + 0.5) < 1e-3);
}

TEST_CASE("zero is straight where it costs next to no reach") {
  KinematicTree tree;
  const FingerSkeleton finger = add_bent_finger(tree, 0.05);
  std::vector<double> q{0.3, 0.3};
  straighten(tree, finger, find_flexion_joints(tree, finger), q);
  CHECK(q[1] == 0);
}

TEST_CASE("whether a finger is straight at zero is told by joints between phalanges alone") {
  const auto told = [](double angle) {
    KinematicTree tree;
    const FingerSkeleton finger = add_bent_finger(tree, angle);
    return is_straight_at_zero(tree, finger, find_flexion_joints(tree, finger), {0.3, 0.3});
  };
  CHECK(told(0) == true);
  CHECK(told(0.5) == false);
  KinematicTree tree;
  const FingerSkeleton finger = add_hinges(tree, -1, {}, {}, kZ, kY, {0.1});
  CHECK_FALSE(is_straight_at_zero(tree, finger, find_flexion_joints(tree, finger), {0}).has_value());
}
