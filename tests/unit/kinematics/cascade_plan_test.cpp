#include "uhas/kinematics/cascade_plan.hpp"

#include <doctest/doctest.h>

#include "support/toy_tree.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr Vector3d kFlexion{0, -1, 0}, kSide{0, 0, 1}, kRoll{1, 0, 0};

/// The plan of the fingers; the named joints are lateral, all others encompassing.
std::vector<CascadeStep> plan(const KinematicTree& tree, const std::vector<std::vector<int>>& fingers,
                              const std::vector<int>& lateral = {}, std::vector<double> q = {}) {
  std::vector<JointClass> classes(tree.joints.size(), JointClass::encompassing);
  for (int joint : lateral) classes[joint] = JointClass::lateral;
  q.resize(tree.joints.size());
  return plan_cascade(tree, fingers, classes, q);
}

std::vector<int> joints_of(const std::vector<CascadeStep>& steps) {
  std::vector<int> joints;
  for (const CascadeStep& step : steps) joints.push_back(step.joint);
  return joints;
}

/// The joint whose origin is the only node of a step; -1 = the fingertip.
int node_of(const CascadeStep& step) {
  REQUIRE(step.nodes.size() == 1);
  return step.nodes[0].joint;
}

int hinge(KinematicTree& tree, int parent, Vector3d origin, Vector3d axis = kFlexion) {
  return add_hinge(tree, parent, origin, axis, -1, 2);
}

}  // namespace

TEST_CASE("encompassing joints come finger by finger, root to tip, and place the next one; the last places the tip") {
  KinematicTree tree;
  const int a = hinge(tree, -1, {1, 0, 0}), b = hinge(tree, -1, {1, 1, 0});
  const int a_side = hinge(tree, a, {1.1, 0, 0}, kSide), a2 = hinge(tree, a_side, {2, 0, 0}),
            b2 = hinge(tree, b, {2, 1, 0});
  const std::vector<CascadeStep> steps = plan(tree, {{b, b2}, {a, a_side, a2}}, {a_side});
  REQUIRE(joints_of(steps) == std::vector<int>{b, b2, a, a2});
  CHECK(node_of(steps[0]) == b2);
  CHECK(node_of(steps[1]) == -1);
  CHECK(node_of(steps[2]) == a2);
  CHECK(node_of(steps[3]) == -1);
  CHECK(steps[2].driven == std::vector<int>{a});
  CHECK(steps[2].fingers == std::vector<int>{1});
  CHECK(steps[2].nodes[0].finger == 1);
}

TEST_CASE("a joint does not place the origin of one that it cannot move") {
  KinematicTree tree;
  const int first = hinge(tree, -1, {1, 0, 0});
  SUBCASE("one that meets it in a point") {
    const int twin = hinge(tree, first, {1, 0, 0}, kSide), next = hinge(tree, twin, {2, 0, 0});
    const std::vector<CascadeStep> steps = plan(tree, {{first, twin, next}});
    CHECK(node_of(steps[0]) == next);
    CHECK(node_of(steps[1]) == next);
  }
  SUBCASE("one further along its axis, in the pose told") {
    const int roll = hinge(tree, first, {2, 0, 0}, kRoll), on_axis = hinge(tree, roll, {3, 0, 0}),
              last = hinge(tree, on_axis, {4, 0, 0});
    const std::vector<std::vector<int>> fingers{{first, roll, on_axis, last}};
    CHECK(node_of(plan(tree, fingers)[1]) == -1);
    CHECK(node_of(plan(tree, fingers, {}, {0, 0, 0.5, 0})[1]) == last);
  }
  SUBCASE("a slide moves whatever it carries") {
    const int slide = add_slide(tree, first, {2, 0, 0}, kRoll, 0, 1), next = hinge(tree, slide, {2, 0, 0});
    CHECK(node_of(plan(tree, {{first, slide, next}})[1]) == next);
  }
}

TEST_CASE("a master and its followers are one unknown that places the fingertip") {
  KinematicTree tree;
  const int first = hinge(tree, -1, {1, 0, 0}), master = hinge(tree, first, {2, 0, 0});
  const int follower = add_follower(tree, master, {3, 0, 0}, kFlexion, master, 0.8);
  const std::vector<CascadeStep> steps = plan(tree, {{first, master, follower}});
  REQUIRE(joints_of(steps) == std::vector<int>{first, master});
  CHECK(node_of(steps[0]) == master);
  CHECK(steps[1].driven == std::vector<int>{master, follower});
  CHECK(node_of(steps[1]) == -1);
}

TEST_CASE("a master outside the fingers is no driven joint of its own") {
  KinematicTree tree;
  const int master = hinge(tree, -1, {0, 0, 0});
  const int follower = add_follower(tree, -1, {1, 0, 0}, kFlexion, master, 0.8);
  const std::vector<CascadeStep> steps = plan(tree, {{follower}});
  REQUIRE(joints_of(steps) == std::vector<int>{master});
  CHECK(steps[0].driven == std::vector<int>{follower});
}

TEST_CASE("what moves several fingers comes first, with a node in each") {
  KinematicTree tree;
  const int single = hinge(tree, -1, {1, 2, 0}), arch = hinge(tree, -1, {1, 0, 0});
  const int a = hinge(tree, arch, {2, 0.3, 0}), b = hinge(tree, arch, {2, -0.3, 0});
  const int master = hinge(tree, -1, {1, 3, 0}), follower = add_follower(tree, b, {3, -0.3, 0}, kFlexion, master, 1);
  const std::vector<CascadeStep> steps = plan(tree, {{single}, {arch, a}, {arch, b, follower}, {master}});
  REQUIRE(joints_of(steps) == std::vector<int>{arch, master, single, a, b});
  CHECK(steps[0].fingers == std::vector<int>{1, 2});
  REQUIRE(steps[0].nodes.size() == 2);
  CHECK(steps[0].nodes[0].finger == 1);
  CHECK(steps[0].nodes[0].joint == a);
  CHECK(steps[0].nodes[1].finger == 2);
  CHECK(steps[0].nodes[1].joint == b);
  CHECK(steps[1].driven == std::vector<int>{master, follower});
  CHECK(steps[1].fingers == std::vector<int>{2, 3});
}
