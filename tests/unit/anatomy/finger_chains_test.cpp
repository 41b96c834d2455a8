#include "uhas/anatomy/palm/finger_chains.hpp"

#include <doctest/doctest.h>

#include "support/toy_hand.hpp"
#include "uhas/base/errors.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

const RigidTransformd kHere{};

Joint hinge(Vector3d axis = {0, 1, 0}) {
  Joint joint;
  joint.axis = axis;
  joint.lower = 0;
  joint.upper = 1;
  return joint;
}

/// Names of the links that the joints of each chain move.
std::vector<std::string> roots_of(const HandModel& model, const FingerChains& found) {
  std::vector<std::string> names;
  for (const std::vector<int>& chain : found.chains) names.push_back(model.tree.joints[chain.front()].name);
  return names;
}

ToyFinger finger_at(const std::string& name, double y) {
  ToyFinger finger;
  finger.name = name;
  finger.root = {0, y, 0.08};
  return finger;
}

HandConfig naming(const std::string& palm_link) {
  HandConfig config;
  config.palm_link = palm_link;
  return config;
}

}  // namespace

TEST_CASE("the palm is where the chains meet, past the wrist") {
  const HandModel model = make_toy_hand({.fingers = 3, .wrist = true});
  const FingerChains found = find_finger_chains(model);
  CHECK(model.links[found.palm_link].name == "palm");
  CHECK(found.palm_group == 0);
  CHECK(found.chains.size() == 4);
  CHECK(found.chains[0].size() == 4);
  CHECK(found.palm_margin == doctest::Approx(1));
}

TEST_CASE("a short movable leaf is no finger and no phalanx") {
  ToyModel toy("decoys");
  const int palm = toy.add_fixed("palm", 0, kHere);
  toy.add_finger(palm, finger_at("a", 0));
  toy.add_finger(palm, finger_at("b", 0.03));
  const int button = toy.add_movable("button", palm, {{}, {0, 0, 0.04}}, hinge());
  toy.add_box(button, {}, {0.005, 0.005, 0.005});
  HandModel model = toy.take();
  CHECK(roots_of(model, find_finger_chains(model)) == std::vector<std::string>{"a_side_joint", "b_side_joint"});
}

TEST_CASE("fingers on one palm-arch joint share it") {
  ToyModel toy("arch");
  const int palm = toy.add_fixed("palm", 0, kHere);
  toy.add_finger(palm, finger_at("a", 0.06));
  const int arch = toy.add_movable("arch", palm, {{}, {0, 0.01, 0.02}}, hinge({0, 0, 1}));
  toy.add_finger(arch, finger_at("b", 0.0));
  toy.add_finger(arch, finger_at("c", -0.03));
  const HandModel model = toy.take();
  const FingerChains found = find_finger_chains(model);
  CHECK(roots_of(model, found) == std::vector<std::string>{"a_side_joint", "arch_joint", "arch_joint"});
  CHECK(found.chains[1][1] != found.chains[2][1]);
}

TEST_CASE("on a shared joint a shorter finger is a finger, a stub is none") {
  ToyModel toy("arch");
  const int palm = toy.add_fixed("palm", 0, kHere);
  toy.add_finger(palm, finger_at("a", 0.06));
  const int arch = toy.add_movable("arch", palm, {{}, {0, 0.01, 0.02}}, hinge({0, 0, 1}));
  toy.add_finger(arch, finger_at("b", 0.0));
  ToyFinger shorter = finger_at("c", -0.03), stub = finger_at("d", -0.06);
  shorter.phalanges = {0.04, 0.02, 0.02};
  stub.phalanges = {0.02};
  toy.add_finger(arch, shorter);
  toy.add_finger(arch, stub);
  const HandModel model = toy.take();
  const FingerChains found = find_finger_chains(model);
  std::vector<std::string> second;
  for (const std::vector<int>& chain : found.chains) second.push_back(model.tree.joints[chain[1]].name);
  CHECK(second == std::vector<std::string>{"a_1_joint", "b_side_joint", "c_side_joint"});
}

TEST_CASE("of the links that make up a palm, the one with most fingers is named, then the one with the larger mesh") {
  for (const bool third_finger : {false, true}) {
    ToyModel toy("plates");
    const int small = toy.add_fixed("small", 0, kHere), large = toy.add_fixed("large", 0, kHere);
    toy.add_box(small, {}, {0.01, 0.01, 0.01});
    for (const double z : {0.0, 0.01}) toy.add_box(large, {0, 0, z}, {0.01, 0.01, 0.01});
    toy.add_finger(small, finger_at("a", 0.06));
    toy.add_finger(large, finger_at("b", 0.0));
    if (third_finger) toy.add_finger(small, finger_at("c", -0.06));
    const HandModel model = toy.take();
    CHECK(model.links[find_finger_chains(model).palm_link].name == (third_finger ? "small" : "large"));
  }
}

TEST_CASE("a linkage that only follows is no finger") {
  ToyModel toy("linkage");
  const int palm = toy.add_fixed("palm", 0, kHere);
  for (const double side : {-1.0, 1.0}) {
    ToyFinger finger = finger_at(side < 0 ? "left" : "right", 0.03 * side);
    finger.side_range = 0;
    const std::vector<int> joints = toy.add_finger(palm, finger);
    Joint follower = hinge();
    follower.mimic_master = joints.front();
    const int bar = toy.add_movable(finger.name + "_bar", palm, {{}, {0, 0.02 * side, 0.08}}, follower);
    toy.add_box(bar, {0, 0, 0.025}, {0.005, 0.005, 0.05});
  }
  const HandModel model = toy.take();
  CHECK(roots_of(model, find_finger_chains(model)) == std::vector<std::string>{"left_1_joint", "right_1_joint"});
}

TEST_CASE("a config may name the palm; one chain is no hand") {
  const HandModel model = make_toy_hand({.fingers = 3, .wrist = true});
  CHECK(find_finger_chains(model, naming("palm")).chains.size() == 4);
  CHECK_THROWS_WITH_AS(find_finger_chains(model, naming("plam")), doctest::Contains("no link \"plam\""), Error);
  CHECK_THROWS_WITH_AS(find_finger_chains(model, naming("index_2")), doctest::Contains("only one finger"), Error);

  ToyModel lonely("lonely");
  CHECK_THROWS_WITH_AS(find_finger_chains(lonely.take()), doctest::Contains("no movable joint"), Error);
}
