#include "uhas/anatomy/fingers/fingertip.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/toy_hand.hpp"
#include "uhas/anatomy/fingers/hand_skeleton.hpp"
#include "uhas/base/errors.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// A palm with two fingers, the first as given.
HandModel make_model(const ToyFinger& finger) {
  ToyModel toy("two");
  const int palm = toy.add_fixed("palm", 0, {});
  toy.add_finger(palm, finger);
  toy.add_finger(palm, {.name = "other", .root = {0, 0.03, 0}});
  return toy.take();
}

PalmTree palm_tree(const HandModel& model) { return make_palm_tree(model, find_finger_chains(model)); }

Fingertip first_tip(const HandModel& model) { return find_fingertips(model, palm_tree(model)).front(); }

}  // namespace

TEST_CASE("fingertip: a frame at the end of the surface") {
  const HandModel model = make_model({.name = "a"});
  const Fingertip tip = first_tip(model);
  CHECK(palm_tree(model).links[tip.link].name == "a_tip");
  CHECK(tip.p_link == Vector3d{});
  CHECK(tip.confidence == 0.95);
}

TEST_CASE("fingertip: the far end of the surface") {
  const HandModel model = make_model({.name = "a", .tip_frame = false});
  const Fingertip tip = first_tip(model);
  CHECK(palm_tree(model).links[tip.link].name == "a_3");
  CHECK(norm(tip.p_link - Vector3d{0, 0, 0.02}) < 1e-9);
  CHECK(tip.confidence == 0.8);
}

TEST_CASE("fingertip: a phalanx as long as the one before") {
  HandModel model = make_model({.name = "a", .tip_frame = false});
  for (ModelLink& link : model.links) link.mesh = {};
  const Fingertip tip = first_tip(model);
  CHECK(norm(tip.p_link - Vector3d{0, 0, 0.03}) < 1e-12);
  CHECK(tip.confidence == 0.3);
}

TEST_CASE("the finding is that of the least certain fingertip") {
  const HandModel model = make_model({.name = "a", .tip_frame = false});
  const HandFinding finding = explain_fingertips(find_fingertips(model, palm_tree(model)));
  CHECK(finding.item == "fingertips");
  CHECK(finding.reason == "far end of the surface of a_3");
  CHECK(finding.confidence == 0.8);
}

TEST_CASE("a skeleton has fingers of some length") {
  const HandModel model = make_model({.name = "a"});
  const PalmTree palm = palm_tree(model);
  const HandSkeleton hand = make_hand_skeleton(palm, find_fingertips(model, palm));
  REQUIRE(hand.finger_count() == 2);
  CHECK(finger_length(hand.tree, hand.fingers[0]) == doctest::Approx(0.1));
  CHECK(mean_finger_length(hand) == doctest::Approx(0.1));

  PalmTree short_palm = palm;
  for (Joint& joint : short_palm.tree.joints) joint.T_parent_joint.translation = {};
  std::vector<Fingertip> on_joint(2);
  for (std::size_t i = 0; i < 2; ++i)
    on_joint[i].link = static_cast<int>(std::ranges::find(palm.links, i == 0 ? "a_3" : "other_3", &ProfileLink::name) -
                                        palm.links.begin());
  CHECK_THROWS_WITH_AS(make_hand_skeleton(short_palm, on_joint), doctest::Contains("has no length"), Error);
}
