#include "uhas/anatomy/anatomy.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "support/model_transforms.hpp"
#include "support/toy_hand.hpp"
#include "uhas/anatomy/palm_plane.hpp"
#include "uhas/base/errors.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

double angle_between(Vector3d a, Vector3d b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

Vector3d normal_in_root(const Anatomy& anatomy) { return anatomy.T_root_palm.rotation * anatomy.palm_normal_palm; }

std::string first_joint(const Anatomy& anatomy, int finger) {
  return finger < 0 ? "none" : anatomy.tree.joints[anatomy.fingers[finger].joints.front()].name;
}

double open_value(const Anatomy& anatomy, const std::string& joint) {
  for (std::size_t i = 0; i < anatomy.tree.joints.size(); ++i)
    if (anatomy.tree.joints[i].name == joint) return anatomy.q_open[i];
  return std::numeric_limits<double>::quiet_NaN();
}

const HandFinding& finding(const Anatomy& anatomy, const std::string& item) {
  for (const HandFinding& f : anatomy.findings)
    if (f.item == item) return f;
  throw std::runtime_error("no finding " + item);
}

bool warns_of(const Anatomy& anatomy, const std::string& key) {
  for (const std::string& warning : anatomy.warnings)
    if (warning.find("\"" + key + "\"") != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a right hand of four fingers and a thumb") {
  const Anatomy anatomy = infer_anatomy(make_toy_hand({.wrist = true}));
  CHECK(anatomy.palm_link == "palm");
  CHECK(anatomy.root_link == "root");
  CHECK(anatomy.other_joints == std::vector<std::string>{"forearm_joint"});
  REQUIRE(anatomy.fingers.size() == 5);
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
  CHECK(first_joint(anatomy, anatomy.thumb) == "thumb_roll_joint");
  CHECK(first_joint(anatomy, anatomy.middle) == "middle_side_joint");
  CHECK(anatomy.handedness == Handedness::right);
  for (const double q : anatomy.q_open) CHECK(std::abs(q) < 0.01);
  for (const FingerAnatomy& finger : anatomy.fingers) {
    CHECK(anatomy.links[finger.tip_link].name.ends_with("_tip"));
    CHECK(angle_between(finger.pad_normal_link, {1, 0, 0}) < 1 * kDegree);
  }
  CHECK(anatomy.warnings.empty());
  for (const char* item :
       {"palm_link", "fingers", "fingertips", "thumb", "middle_finger", "handedness", "palm_normal_in_root", "q_open"})
    CHECK(finding(anatomy, item).confidence > 0.7);
}

TEST_CASE("hands with three fingers beside the thumb have a middle finger, with two none") {
  const Anatomy four = infer_anatomy(make_toy_hand({.fingers = 3}));
  CHECK(first_joint(four, four.middle) == "middle_side_joint");
  const Anatomy three = infer_anatomy(make_toy_hand({.fingers = 2}));
  CHECK(first_joint(three, three.thumb) == "thumb_roll_joint");
  CHECK(three.middle == -1);
}

TEST_CASE("the mirror image is a left hand with the mirrored normal") {
  const Anatomy anatomy = infer_anatomy(mirrored(make_toy_hand()));
  CHECK(anatomy.handedness == Handedness::left);
  CHECK(angle_between(normal_in_root(anatomy), {-1, 0, 0}) < 1 * kDegree);
}

TEST_CASE("an open pose far from zero is found") {
  const HandModel model = make_toy_hand();
  std::vector<double> offset(model.tree.joints.size());
  for (std::size_t i = 0; i < offset.size(); ++i) offset[i] = i % 2 == 0 ? 0.8 : -1.1;
  const Anatomy anatomy = infer_anatomy(with_moved_zeros(model, offset));
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 15 * kDegree);
  CHECK(anatomy.handedness == Handedness::right);
  for (std::size_t i = 0; i < offset.size(); ++i) CHECK(std::abs(anatomy.q_open[i] - offset[i]) < 0.25);
}

TEST_CASE("a thumb's roll joint turns the pad to the palm normal") {
  ToyHandOptions options;
  options.thumb.closing = {0, 0, 1};  // at zero the thumb bends within the palm plane
  options.thumb.roll_range = 1.9;
  const Anatomy anatomy = infer_anatomy(make_toy_hand(options));
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
  CHECK(std::abs(open_value(anatomy, "thumb_roll_joint")) == doctest::Approx(std::numbers::pi / 2).epsilon(0.01));
}

TEST_CASE("followers follow, and one master may drive every finger") {
  ToyHandOptions options;
  options.finger.followers = true;
  options.finger.side_range = 0;
  HandModel model = make_toy_hand(options);
  int master = -1;
  for (std::size_t i = 0; i < model.tree.joints.size(); ++i) {
    Joint& joint = model.tree.joints[i];
    if (joint.name.starts_with("thumb")) continue;
    if (master < 0)
      master = static_cast<int>(i);
    else
      joint.mimic_master = master;
  }
  const Anatomy anatomy = infer_anatomy(model);
  CHECK(anatomy.fingers.size() == 5);
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
  CHECK(open_value(anatomy, "index_1_joint") == doctest::Approx(0));
}

TEST_CASE("a master that stands outside the fingers is kept where it stands") {
  constexpr double least_turn = 0.2;
  HandModel hand = make_toy_hand({.wrist = true});
  ToyModel stand("stand");  // beside the forearm, on a joint that moves no finger
  Joint turn;
  turn.axis = {0, 0, 1};
  turn.lower = least_turn;
  turn.upper = 0.5;
  const int mount = stand.add_movable("mount", 0, {{}, {0.1, 0, 0}}, turn);
  stand.add_movable("motor", mount, {{}, {0, 0.005, 0}}, turn);
  const HandModel extra = stand.take();
  const int joints = static_cast<int>(hand.tree.joints.size()), links = static_cast<int>(hand.links.size());
  for (Joint joint : extra.tree.joints) {
    if (joint.parent >= 0) joint.parent += joints;
    hand.tree.joints.push_back(joint);
  }
  for (std::size_t i = 1; i < extra.links.size(); ++i) {
    ModelLink link = extra.links[i];
    link.parent_link = link.parent_link == 0 ? 0 : link.parent_link + links - 1;
    link.joint += joints;
    hand.links.push_back(link);
  }
  const int motor = joints + 1;
  for (Joint& joint : hand.tree.joints)
    if (joint.name == "index_3_joint") joint.mimic_master = motor;

  const Anatomy anatomy = infer_anatomy(hand);
  CHECK(anatomy.other_joints == std::vector<std::string>{"forearm_joint", "mount_joint"});
  const Joint& kept = anatomy.tree.joints.back();
  REQUIRE(kept.name == "motor_joint");
  CHECK(kept.parent == -1);
  // the root is 0.03 m above the palm when the wrist is at zero; the mount stands at its least turn
  const Vector3d origin{0.1 - 0.005 * std::sin(least_turn), 0.005 * std::cos(least_turn), 0.03};
  CHECK(norm(kept.T_parent_joint.translation - origin) < 1e-12);

  const HandConfig config = parse_hand_config(R"({"thumb": "motor_joint"})", "hand.json");
  CHECK_THROWS_WITH_AS(infer_anatomy(hand, config),
                       "hand.json: thumb: \"motor_joint\" only drives joints of fingers; name a joint of a finger",
                       Error);
}

TEST_CASE("a follower that no value of its master suits is named") {
  ToyHandOptions options;
  options.finger.followers = true;
  HandModel model = make_toy_hand(options);
  for (Joint& joint : model.tree.joints)
    if (joint.name == "ring_2_joint") joint.mimic_offset = 5;
  const Anatomy anatomy = infer_anatomy(model);
  const std::string expected =
      "joint 'ring_2_joint' leaves its limits wherever 'ring_1_joint', which it mimics, stands";
  CHECK(std::count(anatomy.warnings.begin(), anatomy.warnings.end(), expected) == 1);
  CHECK(infer_anatomy(make_toy_hand({.finger = {.followers = true}})).warnings.empty());
}

TEST_CASE("the fingertip is the far end of the surface when no frame stands there") {
  ToyHandOptions options;
  options.finger.tip_frame = false;
  const Anatomy anatomy = infer_anatomy(make_toy_hand(options));
  const FingerAnatomy& middle = anatomy.fingers[anatomy.middle];
  CHECK(anatomy.links[middle.tip_link].name == "middle_3");
  CHECK(norm(middle.p_tip_link - Vector3d{0, 0, 0.02}) < 1e-9);
}

TEST_CASE("a cover on the last phalanx is no fingertip") {
  ToyHandOptions options;
  HandModel model = make_toy_hand(options);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (model.links[i].name != "middle_3") continue;
    ModelLink cover{"middle_cover", static_cast<int>(i), model.links[i].joint, {{}, {0.004, 0, 0.005}}, {}};
    model.links.push_back(cover);
  }
  const Anatomy anatomy = infer_anatomy(model);
  CHECK(anatomy.links[anatomy.fingers[anatomy.middle].tip_link].name == "middle_tip");
}

TEST_CASE("a last phalanx with neither frame nor surface is taken to be as long as the one before it") {
  ToyHandOptions options;
  options.finger.tip_frame = false;
  options.finger.phalanges = {0.05, 0.03, 0.02};
  HandModel model = make_toy_hand(options);
  for (ModelLink& link : model.links)
    if (link.name == "middle_3") link.mesh = {};
  const Anatomy anatomy = infer_anatomy(model);
  const FingerAnatomy& middle = anatomy.fingers[anatomy.middle];
  CHECK(anatomy.links[middle.tip_link].name == "middle_3");
  CHECK(norm(middle.p_tip_link - Vector3d{0, 0, 0.03}) < 1e-12);
  CHECK(finding(anatomy, "fingertips").reason ==
        "middle_3 has no geometry; a phalanx as long as the one before is assumed");
  CHECK(warns_of(anatomy, "fingertips"));
}

TEST_CASE("a radial gripper closes around its axis and has no handedness") {
  for (const int fingers : {3, 4}) {
    CAPTURE(fingers);
    const Anatomy anatomy = infer_anatomy(make_toy_gripper(fingers));
    CHECK(angle_between(normal_in_root(anatomy), {0, 0, 1}) < 1 * kDegree);
    CHECK(anatomy.thumb == -1);
    CHECK(anatomy.middle == -1);
    CHECK(anatomy.handedness == Handedness::none);
  }
}

TEST_CASE("jaws that slide open as far as they go; the normal is the way they reach") {
  const Anatomy anatomy = infer_anatomy(make_toy_parallel_gripper());
  CHECK(angle_between(normal_in_root(anatomy), {0, 0, 1}) < 10 * kDegree);
  CHECK(anatomy.handedness == Handedness::none);
  for (const double q : anatomy.q_open) CHECK(q == doctest::Approx(0.04));
}

TEST_CASE("a continuous joint has half a turn to both sides of open") {
  HandModel model = make_toy_hand();
  Joint& side = model.tree.joints.front();
  side.kind = JointKind::continuous;
  side.lower = -std::numeric_limits<double>::infinity();
  side.upper = std::numeric_limits<double>::infinity();
  const Anatomy anatomy = infer_anatomy(model);
  const Joint& joint = anatomy.tree.joints.front();
  CHECK(joint.lower == doctest::Approx(anatomy.q_open.front() - std::numbers::pi));
  CHECK(joint.upper == doctest::Approx(anatomy.q_open.front() + std::numbers::pi));
}

TEST_CASE("an axis gizmo on the root is no palm") {
  for (const bool wrist : {false, true}) {
    HandModel model = make_toy_hand({.wrist = wrist});
    ToyModel gizmo("gizmo");
    for (const Vector3d axis : {Vector3d{1, 0, 0}, Vector3d{0, 1, 0}, Vector3d{0, 0, 1}})
      gizmo.add_box(0, 0.05 * axis, 0.099 * axis + Vector3d{0.001, 0.001, 0.001});
    model.links[0].mesh = gizmo.model().links[0].mesh;
    const Anatomy anatomy = infer_anatomy(model);
    CHECK(anatomy.palm_link == "palm");
    CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
    CHECK(anatomy.warnings.empty());
  }
}

TEST_CASE("a palm of several fixed links, one of them named like a finger") {
  HandModel model = make_toy_hand();
  const auto palm = std::ranges::find(model.links, "palm", &ModelLink::name);
  const auto part = [&](const std::string& name, Vector3d place) {
    ModelLink link{name, static_cast<int>(palm - model.links.begin()), -1, {{}, place}, {}};
    ToyModel box("box");
    box.add_box(0, {}, {0.02, 0.03, 0.03});
    link.mesh = box.model().links[0].mesh;
    return link;
  };
  palm->name = "index_finger_tip";
  const ModelLink heel = part("heel", {0, 0.02, 0.03}), edge = part("palm", {0, -0.02, 0.03});
  model.links.push_back(heel);
  model.links.push_back(edge);
  const Anatomy anatomy = infer_anatomy(model);
  CHECK(anatomy.palm_link == "index_finger_tip");
  CHECK(anatomy.fingers.size() == 5);
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
  CHECK(anatomy.warnings.empty());
}

TEST_CASE("joints that bend as far back as they close, with the finger straight at zero") {
  ToyHandOptions options;
  options.finger.hyperextension = 1.6;
  const Anatomy anatomy = infer_anatomy(make_toy_hand(options));
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
  for (const double q : anatomy.q_open) CHECK(std::abs(q) < 0.01);
}

TEST_CASE("a side joint on the last phalanx is no flexion joint") {
  HandModel model = make_toy_hand();
  for (Joint& joint : model.tree.joints) {
    if (!joint.name.ends_with("_3_joint") || joint.name.starts_with("thumb")) continue;
    joint.axis = {1, 0, 0};
    joint.lower = -0.4;
    joint.upper = 0.4;
  }
  const Anatomy anatomy = infer_anatomy(model);
  CHECK(angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree);
  CHECK(first_joint(anatomy, anatomy.thumb) == "thumb_roll_joint");
  CHECK(anatomy.warnings.empty());
}

TEST_CASE("what only the range of a joint tells of the normal is doubtful; a stated open pose settles it") {
  ToyHandOptions options;  // no side joints, no palm surface, and zeros that say nothing
  options.finger.side_range = 0;
  options.finger.hyperextension = 0.6;
  options.finger.flexion = 1.1;
  HandModel model = make_toy_hand(options);
  for (ModelLink& link : model.links)
    if (link.name == "palm") link.mesh = {};
  std::vector<double> offset;
  for (std::size_t i = 0; i < model.tree.joints.size(); ++i) offset.push_back(0.7);
  model = with_moved_zeros(model, offset);
  const Anatomy guessed = infer_anatomy(model);
  CHECK(angle_between(normal_in_root(guessed), {1, 0, 0}) > 15 * kDegree);
  CHECK(warns_of(guessed, "palm_normal_in_root"));

  HandConfig config;
  for (const char* finger : {"index", "middle", "ring", "pinky"}) config.q_open[finger + std::string("_1_joint")] = 0.7;
  const Anatomy stated = infer_anatomy(model, config);
  CHECK(angle_between(normal_in_root(stated), {1, 0, 0}) < 3 * kDegree);
  CHECK_FALSE(warns_of(stated, "palm_normal_in_root"));
}

TEST_CASE("a palm that tilts from the way to the knuckles is a poor witness") {
  // as above, but with a palm: straight it tells the normal, tilted by 20 degrees it is not believed
  for (const double tilt : {0.0, 20 * kDegree}) {
    ToyModel toy("slab");
    const int palm = toy.add_fixed("palm", 0, {});
    toy.add_box(palm, {0, 0, 0.04}, {0.02, 0.08, 0.08}, Rotationd::about({0, 1, 0}, tilt));
    for (int i = 0; i < 4; ++i)
      toy.add_finger(palm,
                     {.name = "finger" + std::to_string(i), .root = {0, 0.022 * i - 0.033, 0.085}, .side_range = 0});
    const HandModel model = toy.take();
    const Anatomy anatomy = infer_anatomy(with_moved_zeros(model, std::vector<double>(model.tree.joints.size(), 0.7)));
    CAPTURE(tilt);
    CHECK((angle_between(normal_in_root(anatomy), {1, 0, 0}) < 1 * kDegree) == (tilt == 0));
    CHECK(warns_of(anatomy, "palm_normal_in_root") == (tilt > 0));
  }
}

TEST_CASE("each config key overrides its item and no other") {
  const HandModel model = make_toy_hand({.wrist = true});
  HandConfig config;
  config.palm_normal_in_root = Vector3d{-2, 0, 0};
  CHECK(normal_in_root(infer_anatomy(model, config)) == Vector3d{-1, 0, 0});
  config = {};
  config.handedness = Handedness::left;
  const Anatomy left = infer_anatomy(model, config);
  CHECK(left.handedness == Handedness::left);
  CHECK(angle_between(normal_in_root(left), {1, 0, 0}) < 1 * kDegree);
  config = {};
  config.q_open = {{"index_2_joint", 0.4}};
  const Anatomy bent = infer_anatomy(model, config);
  CHECK(open_value(bent, "index_2_joint") == 0.4);
  CHECK(open_value(bent, "middle_2_joint") == doctest::Approx(0));
  config.q_open = {{"index_9_joint", 0.4}};
  CHECK_THROWS_WITH_AS(infer_anatomy(model, config), doctest::Contains("no finger has a joint \"index_9_joint\""),
                       Error);
  config.q_open = {{"index_2_joint", 4}};
  CHECK_THROWS_WITH_AS(infer_anatomy(model, config), doctest::Contains("outside the limits"), Error);
}

TEST_CASE("a doubtful normal lowers the confidence and names the key") {
  ToyHandOptions options;  // fingers that bend as far to one side as to the other
  options.finger.hyperextension = 1.6;
  options.finger.phalanges = {0.1};
  options.thumb = options.finger;
  const Anatomy anatomy = infer_anatomy(make_toy_hand(options));
  CHECK(finding(anatomy, "palm_normal_in_root").confidence < 0.5);
  CHECK(warns_of(anatomy, "palm_normal_in_root"));
}
