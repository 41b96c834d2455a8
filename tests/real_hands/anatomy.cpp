// What is inferred from a real hand's URDF alone agrees with its truth.json.
#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <set>

#include "support/real_hand.hpp"
#include "uhas/sphere_frame/sphere_frame.hpp"

using namespace uhas;
using namespace uhas::test;
using nlohmann::json;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

const HandModel& model() {
  static const HandModel loaded = load_hand_model(real_hand().urdf.string());
  return loaded;
}

struct Inferred {
  Anatomy anatomy;
  SphereFrame frame;
};

Inferred infer(const HandModel& hand) {
  Inferred result{infer_anatomy(hand), {}};
  result.frame = compute_sphere_frame(result.anatomy);
  return result;
}

Vector3d vector(const json& value) { return {value.at(0), value.at(1), value.at(2)}; }

double angle_between(Vector3d a, Vector3d b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

std::vector<std::string> chain_of(const Anatomy& anatomy, const FingerAnatomy& finger) {
  std::vector<std::string> names;
  for (int joint : finger.joints) names.push_back(anatomy.tree.joints[joint].name);
  return names;
}

/// The inferred finger with the chain of a finger in truth.json; -1 = none has it.
int find_finger(const Anatomy& anatomy, const json& truth_finger) {
  const auto chain = truth_finger.at("chain").get<std::vector<std::string>>();
  for (std::size_t i = 0; i < anatomy.fingers.size(); ++i)
    if (chain_of(anatomy, anatomy.fingers[i]) == chain) return static_cast<int>(i);
  return -1;
}

}  // namespace

TEST_CASE("palm, fingers and other joints") {
  const json& truth = real_hand().truth;
  const Anatomy anatomy = infer(model()).anatomy;
  const auto palm_group = truth.at("palm_rigid_group").get<std::set<std::string>>();
  CHECK(palm_group.contains(anatomy.palm_link));
  CHECK(anatomy.fingers.size() == truth.at("n_fingers").get<std::size_t>());
  for (const json& finger : truth.at("fingers")) {
    CAPTURE(finger.at("name").get<std::string>());
    CHECK(find_finger(anatomy, finger) >= 0);
  }
  const std::set<std::string> other(anatomy.other_joints.begin(), anatomy.other_joints.end());
  CHECK(other == truth.at("non_finger_joints").get<std::set<std::string>>());
  CHECK(anatomy.warnings.empty());
}

TEST_CASE("palm normal, middle finger and handedness") {
  const json& truth = real_hand().truth;
  const auto [anatomy, frame] = infer(model());
  const Rotationd R_root_sphere = anatomy.T_root_palm.rotation * frame.T_palm_sphere.rotation;
  CHECK(angle_between(R_root_sphere.column(2), vector(truth.at("palm_normal_in_root"))) <
        truth.at("palm_normal_tolerance_deg").get<double>() * kDegree);
  const std::map<std::string, Handedness> hands = {
      {"right", Handedness::right}, {"left", Handedness::left}, {"none", Handedness::none}};
  CHECK(anatomy.handedness == hands.at(truth.at("handedness")));
  for (const json& finger : truth.at("fingers")) {
    if (finger.at("name") != "middle") continue;
    CHECK(anatomy.middle == find_finger(anatomy, finger));
    CHECK(angle_between(R_root_sphere.column(0), vector(truth.at("middle_finger_direction_in_root"))) <
          truth.at("middle_finger_direction_tolerance_deg").get<double>() * kDegree);
  }
}

TEST_CASE("open pose and fingertips") {
  const json& truth = real_hand().truth;
  const auto [anatomy, frame] = infer(model());
  for (std::size_t i = 0; i < anatomy.tree.joints.size(); ++i) {
    const Joint& joint = anatomy.tree.joints[i];
    CHECK(anatomy.q_open[i] >= joint.lower - 1e-9);
    CHECK(anatomy.q_open[i] <= joint.upper + 1e-9);
    if (joint.mimic_master >= 0) continue;
    CAPTURE(joint.name);
    CHECK(std::abs(anatomy.q_open[i] - truth.at("open_pose").at(joint.name).get<double>()) < 0.35);
  }
  for (const json& finger : truth.at("fingers")) {
    const int i = find_finger(anatomy, finger);
    REQUIRE(i >= 0);
    CAPTURE(finger.at("name").get<std::string>());
    const Vector3d tip = fingertip_in_sphere(anatomy, frame, i, anatomy.q_open);
    const Vector3d tip_root = anatomy.T_root_palm * (frame.T_palm_sphere * tip);
    CHECK(norm(tip_root - vector(finger.at("tip_point_in_root_at_open"))) < 0.1 * frame.radius);
  }
}

TEST_CASE("slots and names") {
  const json& truth = real_hand().truth;
  const auto [anatomy, frame] = infer(model());
  const std::map<std::string, std::size_t> slot = {
      {"pinky", 0}, {"ring", 1}, {"middle", 2}, {"index", 3}, {"thumb", 4}};
  for (std::size_t s = 0; s < kSlotCount; ++s)
    CHECK(std::count_if(frame.slots.begin(), frame.slots.end(), [s](const auto& owned) { return owned[s]; }) == 1);
  for (const json& finger : truth.at("fingers")) {
    const auto named = slot.find(finger.at("name"));
    if (named == slot.end()) continue;
    const int i = find_finger(anatomy, finger);
    REQUIRE(i >= 0);
    CHECK(frame.slots[i][named->second]);
    CHECK(frame.names[i] == named->first);
  }
}

TEST_CASE("the radius is an independent prototype's within 5 %") {
  const std::map<std::string, double> radius = {
      {"allegro_right", 0.1085}, {"allegro_left", 0.1087},  {"leap_right", 0.1019}, {"shadow_right", 0.0764},
      {"human_hand", 0.0743},    {"inspire_right", 0.0620}, {"dg3f_m", 0.1027}};
  CHECK(infer(model()).frame.radius == doctest::Approx(radius.at(real_hand().name)).epsilon(0.05));
}
