#include "uhas/anatomy/palm/palm_tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "support/toy_hand.hpp"
#include "uhas/anatomy/palm/palm_slab.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

PalmTree palm_tree(const HandModel& model, const HandConfig& config = {}) {
  return make_palm_tree(model, find_finger_chains(model, config), config);
}

const Joint& joint_named(const PalmTree& palm, const std::string& name) {
  return *std::ranges::find(palm.tree.joints, name, &Joint::name);
}

}  // namespace

TEST_CASE("the tree begins in the palm and holds the fingers alone") {
  HandModel model = make_toy_hand({.fingers = 2, .wrist = true});
  model.tree.joints.front().lower = 0.25;  // the wrist cannot stand at zero
  const PalmTree palm = palm_tree(model);
  CHECK(palm.root_link == "root");
  CHECK(palm.palm_link == "palm");
  CHECK(palm.other_joints == std::vector<std::string>{"forearm_joint"});
  CHECK(palm.tree.joints.size() == model.tree.joints.size() - 1);
  CHECK(palm.chains.size() == 3);
  for (const std::vector<int>& chain : palm.chains) {
    CHECK(palm.tree.joints[chain.front()].parent == -1);
    for (std::size_t i = 1; i < chain.size(); ++i) CHECK(palm.tree.joints[chain[i]].parent == chain[i - 1]);
  }
  CHECK(norm(joint_named(palm, "index_side_joint").T_parent_joint.translation - Vector3d{0, 0.022, 0.085}) < 1e-12);
  const Vector3d p_palm{0.02 * std::sin(0.25), 0, 0.02 * std::cos(0.25) - 0.05};
  CHECK(norm(palm.T_root_palm.translation - p_palm) < 1e-12);
}

TEST_CASE("links of the palm and of the fingers stay, with where they are in the model") {
  const HandModel model = make_toy_hand({.fingers = 2, .wrist = true});
  const PalmTree palm = palm_tree(model);
  CHECK(palm.links.size() == model.links.size() - 1);  // without the root
  for (std::size_t i = 0; i < palm.links.size(); ++i) {
    CHECK(palm.links[i].name == model.links[palm.model_links[i]].name);
    if (palm.links[i].name == "palm") CHECK(palm.links[i].joint == -1);
    if (palm.links[i].name == "index_tip") CHECK(palm.tree.joints[palm.links[i].joint].name == "index_3_joint");
  }
}

TEST_CASE("a master is narrowed to what its followers can do") {
  ToyHandOptions options;
  options.finger.followers = true;
  HandModel model = make_toy_hand(options);
  for (Joint& joint : model.tree.joints)
    if (joint.name == "index_2_joint") joint.mimic_multiplier = 2;
  const PalmTree palm = palm_tree(model);
  CHECK(joint_named(palm, "index_1_joint").lower == 0);
  CHECK(joint_named(palm, "index_1_joint").upper == 0.8);
  CHECK(joint_named(palm, "middle_1_joint").upper == 1.6);
  CHECK(palm.warnings.empty());
}

TEST_CASE("what is said of palm and fingers") {
  const PalmTree found = palm_tree(make_toy_hand());
  REQUIRE(found.findings.size() == 2);
  CHECK(found.findings[0].item == "palm_link");
  CHECK(found.findings[1].item == "fingers");
  CHECK(found.findings[1].value == "5 fingers");

  HandConfig config;
  config.palm_link = "palm";
  config.joint_limits["index_2_joint"] = {0.1, 1.5};
  const PalmTree stated = palm_tree(make_toy_hand(), config);
  REQUIRE(stated.findings.size() == 3);
  CHECK(stated.findings[0] == HandFinding{"joint_limits", "1 joint narrowed", kStatedInConfig, 1});
  CHECK(stated.findings[1] == HandFinding{"palm_link", "palm", kStatedInConfig, 1});
}

TEST_CASE("a palm that is thin and reaches toward the knuckles is a slab") {
  const HandModel model = make_toy_hand();
  const std::optional<PalmSlab> slab = find_palm_slab(model, palm_tree(model), {0, 0, 0.085});
  REQUIRE(slab.has_value());
  CHECK(std::abs(slab->normal.x) == doctest::Approx(1));
  CHECK(slab->error == doctest::Approx(0.1));
  CHECK(find_palm_slab(model, palm_tree(model), {0.04, 0, 0.08})->error == doctest::Approx(std::numbers::pi / 4));

  ToyModel cube("cube");
  const int palm = cube.add_fixed("palm", 0, {});
  cube.add_box(palm, {}, {0.05, 0.05, 0.05});
  cube.add_finger(palm, {.name = "a"});
  cube.add_finger(palm, {.name = "b", .root = {0, 0.03, 0}});
  CHECK_FALSE(find_palm_slab(cube.model(), palm_tree(cube.model()), {}).has_value());
}
