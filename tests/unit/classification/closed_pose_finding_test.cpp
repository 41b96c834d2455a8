#include "uhas/classification/closed_pose_finding.hpp"

#include <doctest/doctest.h>

#include "support/sphere_hand.hpp"
#include "uhas/classification/closed_pose.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// A finger along +x whose pad faces +z, toward the sphere; its three joints close it that way.
SphereHand make_hand() {
  SphereHand hand;
  add_planar_finger(hand, {});
  hand.anatomy.fingers[0].pad_normal_link = {0, 0, 1};
  return hand;
}

HandFinding explain(const SphereHand& hand, const std::vector<double>& q_closed, const HandConfig& config = {}) {
  const std::vector<JointClassification> classes = classify_joints(hand.anatomy, hand.frame, q_closed);
  return explain_closed_pose(hand.anatomy, hand.frame, classes, q_closed, config);
}

}  // namespace

TEST_CASE("joints that begin to close toward where the pad faces are sure") {
  const SphereHand hand = make_hand();
  const HandFinding finding = explain(hand, find_closed_pose(hand.anatomy, hand.frame));
  CHECK(finding.item == "q_closed");
  CHECK(finding.confidence == 1);
  CHECK(doubt(finding).empty());
}

TEST_CASE("the confidence is the part of the joints that do") {
  const SphereHand hand = make_hand();
  CHECK(explain(hand, {1.8, 1.8, -0.5}).confidence == doctest::Approx(2.0 / 3));
  const HandFinding finding = explain(hand, {1.8, -0.5, -0.5});
  CHECK(finding.confidence == doctest::Approx(1.0 / 3));
  CHECK(doubt(finding).find("\"q_closed\"") != std::string::npos);
}

TEST_CASE("side joints have no say") {
  SphereHand hand;
  const int side = add_hinge(hand.tree(), -1, {0.3, 0, -1}, {0, 0, 1}, -0.5, 0.5);
  add_planar_finger(hand, {}, {side});
  hand.anatomy.fingers[0].pad_normal_link = {0, 0, 1};
  REQUIRE(classify_joints(hand.anatomy, hand.frame, std::vector<double>{0.5, 1.8, 1.8, 1.8})[0].joint_class ==
          JointClass::lateral);
  CHECK(explain(hand, {0.5, 1.8, 1.8, 1.8}).confidence == 1);
}

TEST_CASE("a config that states every joint is believed, one that states some is not") {
  const SphereHand hand = make_hand();
  HandConfig config;
  const auto state = [&](int joint, double value) { config.q_closed[hand.anatomy.tree.joints[joint].name] = value; };
  for (int joint : {0, 1}) state(joint, -0.5);
  CHECK(explain(hand, {-0.5, -0.5, 1.8}, config).confidence < 0.5);
  state(2, 1.8);
  const HandFinding finding = explain(hand, {-0.5, -0.5, 1.8}, config);
  CHECK(finding.confidence == 1);
  CHECK(finding.reason == kStatedInConfig);
}
