// Compiled joints against forward kinematics, which turns about any axis by Rodrigues' formula.
#include "uhas/kinematics/compiled_joint.hpp"

#include <doctest/doctest.h>

#include <random>

#include "support/toy_tree.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/joint_travel.hpp"

using namespace uhas;

namespace {

/// A hinge, a slide and followers of both, with axes and frames that point anywhere.
KinematicTree skew_tree() {
  KinematicTree tree;
  test::add_hinge(tree, -1, {0.01, 0.02, 0}, normalized(Vector3d{1, 2, -2}), -1, 1);
  test::add_slide(tree, 0, {0.05, 0.02, 0}, normalized(Vector3d{-3, 0.5, 1}), -0.01, 0.03);
  test::add_follower(tree, 1, {0.07, 0, 0.01}, {0, 0, -1}, 1, 20);  // turns as the slide slides
  test::add_follower(tree, 2, {0.09, 0, 0.02}, {0, -1, 0}, 0, -0.5);
  test::add_slide(tree, 3, {0.1, 0, 0}, {1, 0, 0}, -1, 1);
  tree.joints[4].mimic_master = 1;
  tree.joints[4].mimic_multiplier = 0.75;
  tree.joints[2].mimic_offset = 0.2, tree.joints[4].mimic_offset = 0.004;
  for (int i = 0; i < 5; ++i)
    tree.joints[i].T_parent_joint.rotation = Rotationd::about(normalized(Vector3d{1, double(i), 0.5}), 0.7 * i);
  return tree;
}

}  // namespace

TEST_CASE("compiled joints place what forward kinematics places, in their own units") {
  const KinematicTree tree = skew_tree();
  const RigidTransformd T_base_root{Rotationd::about({0, 0.6, 0.8}, 0.4), {0.3, -0.2, 0.1}};
  constexpr double radius = 0.08;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const LengthUnits units : {LengthUnits{}, LengthUnits{radius, 1}, LengthUnits{radius, radius}}) {
    std::vector<double> q{uniform(random), 0.02 * uniform(random), 0, 0, 0};
    apply_mimics(tree, q);
    std::vector<RigidTransformd> T_root_joint(tree.joints.size()), T_base_compiled(tree.joints.size());
    forward_kinematics(tree, q, T_root_joint);

    for (int i = 0; i < 5; ++i) {
      const CompiledJoint<double> joint = compile_joint(tree, i, T_base_root, units);
      const bool source_slides = tree.joints[joint.source].kind == JointKind::prismatic;
      const double motion = joint.motion_at(q[joint.source] / (source_slides ? units.q : 1));
      const RigidTransformd F =
          joint.parent < 0 ? joint.T_parent_joint : T_base_compiled[joint.parent] * joint.T_parent_joint;
      T_base_compiled[i] = joint.moved(F, JointValue<double>{motion, std::cos(motion), std::sin(motion)});

      const Vector3d origin = T_base_root * T_root_joint[i].translation;
      const Vector3d axis = T_base_root.rotation * (T_root_joint[i].rotation * tree.joints[i].axis);
      CAPTURE(i);
      CHECK(norm(units.motion * T_base_compiled[i].translation - origin) < 1e-14);
      CHECK(norm(T_base_compiled[i].rotation.column(2) - axis) < 1e-14);
    }
  }
}

TEST_CASE("a compiled joint says which joint decides") {
  const KinematicTree tree = skew_tree();
  const CompiledJoint<double> master = compile_joint(tree, 0, {}, {}), follower = compile_joint(tree, 3, {}, {});
  CHECK(master.source == 0);
  CHECK_FALSE(master.follows);
  CHECK_FALSE(master.mimics(0));
  CHECK(follower.source == 0);
  CHECK(follower.mimics(0));
  CHECK_FALSE(follower.mimics(1));
}

TEST_CASE("a joint's opposite end is the limit far from its closed end") {
  Joint joint;
  joint.lower = -0.5, joint.upper = 1.5;
  CHECK(travel_of(joint, 0.1, 1.5).opposite == -0.5);
  CHECK(travel_of(joint, 0.1, -0.5).opposite == 1.5);
  CHECK(travel_of(joint, 0.1, 1.2).opposite == -0.5);
  CHECK(travel_of(joint, 0.1, 0.5).opposite == -0.5);  // half way between: as if it closed upward
  const JointTravel<float> halves = travel_of(joint, 0.25, 1.5).in_units_of<float>(2);
  CHECK(halves.open == 0.125f);
  CHECK(halves.closed == 0.75f);
  CHECK(halves.opposite == -0.25f);
}
