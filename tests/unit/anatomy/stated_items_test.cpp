// Every key of the hand config, set alone: it decides its item, leaves the others, and is refused when it
// makes no sense.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "support/toy_hand.hpp"
#include "uhas/anatomy/anatomy.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/classification/closed_pose.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

const HandModel& hand() {
  static const HandModel model = make_toy_hand({.wrist = true});
  return model;
}

HandConfig config(const std::string& json) { return parse_hand_config(json, "hand.json"); }

Anatomy infer(const std::string& json) { return infer_anatomy(hand(), config(json)); }

/// What the library says when it refuses the config; "" when it does not.
std::string refusal(const std::string& json) {
  try {
    infer(json);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::invalid_config);
    return error.what();
  }
  return "";
}

const HandFinding& finding(const Anatomy& anatomy, const std::string& item) {
  for (const HandFinding& f : anatomy.findings)
    if (f.item == item) return f;
  throw std::runtime_error("no finding " + item);
}

/// The item is stated; every other has the confidence and the reason it has without a config.
void check_only_stated(const Anatomy& anatomy, const std::string& item) {
  CHECK(finding(anatomy, item).confidence == 1);
  CHECK(finding(anatomy, item).reason == "stated in the hand config");
  const Anatomy inferred = infer("{}");
  for (const HandFinding& f : inferred.findings)
    if (f.item != item) CHECK(finding(anatomy, f.item) == f);
}

std::string last_joint(const Anatomy& anatomy, int finger) {
  return finger < 0 ? "none" : anatomy.tree.joints[anatomy.fingers[finger].joints.back()].name;
}

const FingerAnatomy& finger_that_ends_with(const Anatomy& anatomy, const std::string& joint) {
  for (std::size_t i = 0; i < anatomy.fingers.size(); ++i)
    if (last_joint(anatomy, static_cast<int>(i)) == joint) return anatomy.fingers[i];
  throw std::runtime_error("no finger ends with " + joint);
}

const Joint& joint_named(const Anatomy& anatomy, const std::string& name) {
  for (const Joint& joint : anatomy.tree.joints)
    if (joint.name == name) return joint;
  throw std::runtime_error("no joint " + name);
}

}  // namespace

TEST_CASE("palm_link") {
  const Anatomy anatomy = infer(R"({"palm_link": "palm"})");
  CHECK(anatomy.palm_link == "palm");
  check_only_stated(anatomy, "palm_link");
  CHECK(refusal(R"({"palm_link": "pam"})") ==
        "hand.json: palm_link: the model has no link \"pam\"; did you mean \"palm\"?");
}

TEST_CASE("palm_normal_in_root") {
  const Anatomy anatomy = infer(R"({"palm_normal_in_root": [2, 0, 0]})");
  CHECK(anatomy.palm_normal_root == Vector3d{1, 0, 0});
  check_only_stated(anatomy, "palm_normal_in_root");
}

TEST_CASE("fingers: those that are stated and no others, in the order of the model") {
  const Anatomy anatomy = infer(R"({"fingers": [
    ["thumb_roll_joint", "thumb_1_joint", "thumb_2_joint", "thumb_3_joint"],
    ["middle_side_joint", "middle_1_joint", "middle_2_joint"],
    ["index_side_joint", "index_1_joint", "index_2_joint", "index_3_joint"]]})");
  REQUIRE(anatomy.fingers.size() == 3);
  CHECK(last_joint(anatomy, 0) == "index_3_joint");
  CHECK(last_joint(anatomy, 1) == "middle_2_joint");
  CHECK(last_joint(anatomy, 2) == "thumb_3_joint");
  CHECK(anatomy.palm_link == "palm");
  CHECK(finding(anatomy, "fingers").reason == "stated in the hand config");
  CHECK(finding(anatomy, "palm_link").reason != "stated in the hand config");
  CHECK(std::ranges::count(anatomy.other_joints, "middle_3_joint") == 1);
}

TEST_CASE("fingers that are none") {
  CHECK(refusal(R"({"fingers": [["index_side_joint"], ["midle_side_joint"]]})") ==
        "hand.json: fingers: the model has no movable joint \"midle_side_joint\"; did you mean \"middle_side_joint\"?");
  CHECK(refusal(R"({"fingers": [["index_side_joint", "index_2_joint"], ["middle_side_joint"]]})") ==
        "hand.json: fingers: \"index_side_joint\" does not carry \"index_2_joint\" directly; "
        "list every joint of a finger, root to tip");
  CHECK(refusal(R"({"fingers": [["index_side_joint"], ["index_side_joint"]]})") ==
        "hand.json: fingers: \"index_side_joint\" ends a finger and is part of another; "
        "list each finger once, to its last joint");
  CHECK(refusal(R"({"fingers": [["index_side_joint"]]})") ==
        "hand.json: fingers: a hand has two or more fingers; list the joints of each");
  CHECK(refusal(R"({"fingers": [["index_side_joint"], ["middle_1_joint"]]})") ==
        "hand.json: fingers: \"index_side_joint\" and \"middle_1_joint\" are not carried by one rigid palm; "
        "begin each finger with the first joint above the palm");
  CHECK(refusal(R"({"palm_link": "root", "fingers": [["index_side_joint"], ["middle_side_joint"]]})") ==
        "hand.json: palm_link: the stated fingers do not begin on \"root\"; "
        "name the link that carries the first joint of each");
}

TEST_CASE("fingertips: link, point and pad normal of one finger") {
  const Anatomy anatomy =
      infer(R"({"fingertips": [{"link": "index_3", "point": [0.001, 0, 0.015], "pad_normal": [0.8, 0, 1.5]}]})");
  const FingerAnatomy& index = finger_that_ends_with(anatomy, "index_3_joint");
  CHECK(anatomy.links[index.tip_link].name == "index_3");
  CHECK(index.p_tip_link == Vector3d{0.001, 0, 0.015});
  CHECK(norm(index.pad_normal_link - Vector3d{8.0 / 17, 0, 15.0 / 17}) < 1e-12);
  const FingerAnatomy& middle = finger_that_ends_with(anatomy, "middle_3_joint");
  CHECK(anatomy.links[middle.tip_link].name == "middle_tip");
}

TEST_CASE("fingertips: without a point, the far end of the link's surface or its origin") {
  const Anatomy anatomy = infer(R"({"fingertips": [{"link": "index_3"}, {"link": "middle_tip"}, {"link": "ring_tip"},
                                                   {"link": "pinky_tip"}, {"link": "thumb_tip"}]})");
  CHECK(norm(finger_that_ends_with(anatomy, "index_3_joint").p_tip_link - Vector3d{0, 0, 0.02}) < 1e-9);
  CHECK(finger_that_ends_with(anatomy, "middle_3_joint").p_tip_link == Vector3d{});
  CHECK(finding(anatomy, "fingertips").reason == "stated in the hand config");
  CHECK(finding(anatomy, "fingertips").confidence == 1);
}

TEST_CASE("fingertips that are none") {
  CHECK(refusal(R"({"fingertips": [{"link": "indx_tip"}]})") ==
        "hand.json: fingertips: no finger has a link \"indx_tip\"; did you mean \"index_tip\"?");
  CHECK(refusal(R"({"fingertips": [{"link": "index_2"}]})") ==
        "hand.json: fingertips: the last joint of a finger does not carry \"index_2\"; "
        "name a link on the last phalanx, or state \"fingers\" that end there");
  CHECK(refusal(R"({"fingertips": [{"link": "index_3"}, {"link": "index_tip"}]})") ==
        "hand.json: fingertips: \"index_3\" and \"index_tip\" are on one finger; a finger has one tip");
}

TEST_CASE("thumb: any joint of it, or none") {
  const Anatomy anatomy = infer(R"({"thumb": "thumb_2_joint"})");
  CHECK(last_joint(anatomy, anatomy.thumb) == "thumb_3_joint");
  check_only_stated(anatomy, "thumb");
  const Anatomy other = infer(R"({"thumb": "pinky_1_joint"})");
  CHECK(last_joint(other, other.thumb) == "pinky_3_joint");
  const Anatomy none = infer(R"({"thumb": null})");
  CHECK(none.thumb == -1);
  CHECK(finding(none, "thumb").value == "none");
  CHECK(finding(none, "thumb").confidence == 1);
  CHECK(refusal(R"({"thumb": "thumb"})") ==
        "hand.json: thumb: no finger has a joint \"thumb\"; did you mean \"thumb_1_joint\"?");
}

TEST_CASE("a joint that several fingers share tells none of them") {
  ToyModel toy("arch");
  const int palm = toy.add_fixed("palm", 0, {});
  const auto finger_at = [](const std::string& name, double y) {
    return ToyFinger{.name = name, .root = {0, y, 0.08}};
  };
  toy.add_finger(palm, finger_at("a", 0.06));
  Joint hinge;
  hinge.upper = 1;
  const int arch = toy.add_movable("arch", palm, {{}, {0, 0.01, 0.02}}, hinge);
  toy.add_finger(arch, finger_at("b", 0.0));
  toy.add_finger(arch, finger_at("c", -0.03));
  CHECK_THROWS_WITH_AS(infer_anatomy(toy.model(), config(R"({"thumb": "arch_joint"})")),
                       "hand.json: thumb: several fingers have the joint \"arch_joint\"; name a joint further out",
                       Error);
}

TEST_CASE("middle_finger: any joint of it, or none") {
  const Anatomy anatomy = infer(R"({"middle_finger": "ring_1_joint"})");
  CHECK(last_joint(anatomy, anatomy.middle) == "ring_3_joint");
  check_only_stated(anatomy, "middle_finger");
  CHECK(infer(R"({"middle_finger": null})").middle == -1);
  CHECK(refusal(R"({"middle_finger": "ring_9_joint"})") ==
        "hand.json: middle_finger: no finger has a joint \"ring_9_joint\"; did you mean \"ring_1_joint\"?");
  CHECK(refusal(R"({"middle_finger": "thumb_1_joint"})") ==
        "hand.json: middle_finger: thumb_roll_joint .. thumb_3_joint is the thumb; "
        "name another finger, or set \"thumb\"");
}

TEST_CASE("handedness") {
  const Anatomy anatomy = infer(R"({"handedness": "none"})");
  CHECK(anatomy.handedness == Handedness::none);
  check_only_stated(anatomy, "handedness");
}

TEST_CASE("q_open: one joint, or all") {
  const Anatomy one = infer(R"({"q_open": {"index_2_joint": 0.25}})");
  CHECK(finding(one, "q_open").reason.ends_with("; 1 joint stated in the hand config"));
  std::string all;
  for (const Joint& joint : one.tree.joints) all += (all.empty() ? "\"" : ", \"") + joint.name + "\": 0";
  CHECK(finding(infer("{\"q_open\": {" + all + "}}"), "q_open").reason == "stated in the hand config");
  CHECK(refusal(R"({"q_open": {"index_2_joint": 4}})") ==
        "hand.json: q_open: 4 is outside the limits of \"index_2_joint\"; stay within [0, 1.6]");
  CHECK(refusal(R"({"q_open": {"index_02_joint": 0}})") ==
        "hand.json: q_open: no finger has a joint \"index_02_joint\"; did you mean \"index_2_joint\"?");
}

TEST_CASE("q_closed") {
  const Anatomy anatomy = infer("{}");
  const SphereFrame frame = compute_sphere_frame(anatomy);
  const std::vector<double> inferred = find_closed_pose(anatomy, frame);
  const std::vector<double> stated = find_closed_pose(anatomy, frame, config(R"({"q_closed": {"index_2_joint": 1}})"));
  for (std::size_t i = 0; i < stated.size(); ++i)
    CHECK(stated[i] == (anatomy.tree.joints[i].name == "index_2_joint" ? 1 : inferred[i]));
  CHECK_THROWS_WITH_AS(find_closed_pose(anatomy, frame, config(R"({"q_closed": {"index_2": 1}})")),
                       "hand.json: q_closed: no finger has a joint \"index_2\"; did you mean \"index_2_joint\"?",
                       Error);
  CHECK_THROWS_WITH_AS(find_closed_pose(anatomy, frame, config(R"({"q_closed": {"index_2_joint": -1}})")),
                       doctest::Contains("-1 is outside the limits"), Error);
}

TEST_CASE("joint_limits narrow and never widen") {
  const Anatomy anatomy = infer(R"({"joint_limits": {"index_2_joint": [0.25, 1.5]}})");
  CHECK(joint_named(anatomy, "index_2_joint").lower == 0.25);
  CHECK(joint_named(anatomy, "index_2_joint").upper == 1.5);
  CHECK(joint_named(anatomy, "middle_2_joint").upper == 1.6);
  CHECK(finding(anatomy, "joint_limits").value == "1 joint narrowed");
  CHECK(refusal(R"({"joint_limits": {"index_2_joint": [0, 1.7]}})") ==
        "hand.json: joint_limits: [0, 1.7] is wider than the limits of \"index_2_joint\"; "
        "they can only be narrowed, within [0, 1.6]");
  CHECK(refusal(R"({"joint_limits": {"index_2_jnt": [0, 1]}})") ==
        "hand.json: joint_limits: no finger has a joint \"index_2_jnt\"; did you mean \"index_2_joint\"?");
  CHECK(refusal(R"({"joint_limits": {"index_2_joint": [0.25, 1.5]}, "q_open": {"index_2_joint": 0}})") ==
        "hand.json: q_open: 0 is outside the limits of \"index_2_joint\"; stay within [0.25, 1.5]");
}

TEST_CASE("joint_limits of a continuous joint stay as stated") {
  HandModel model = make_toy_hand();
  Joint& side = model.tree.joints.front();
  side.kind = JointKind::continuous;
  side.lower = -std::numeric_limits<double>::infinity();
  side.upper = std::numeric_limits<double>::infinity();
  const Anatomy anatomy = infer_anatomy(model, config("{\"joint_limits\": {\"" + side.name + "\": [-0.5, 0.75]}}"));
  CHECK(anatomy.tree.joints.front().lower == -0.5);
  CHECK(anatomy.tree.joints.front().upper == 0.75);
}

TEST_CASE("limits of a follower narrow its master") {
  ToyHandOptions options;
  options.finger.followers = true;
  const Anatomy anatomy =
      infer_anatomy(make_toy_hand(options), config(R"({"joint_limits": {"index_2_joint": [0, 1]}})"));
  CHECK(joint_named(anatomy, "index_1_joint").upper == 1);
  CHECK(joint_named(anatomy, "middle_1_joint").upper == 1.6);
}
