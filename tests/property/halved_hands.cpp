// A hand that has lost half of its fingers, whichever: its palm normal stays right, or the confidence says that it is
// in doubt and a warning names the key that settles it.
#include <doctest/doctest.h>

#include <bit>
#include <iostream>
#include <numbers>

#include "support/real_hand.hpp"
#include "uhas/anatomy/anatomy.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kNormalTolerance = 15 * kDegree;
constexpr const char* kKey = "palm_normal_in_root";

/// The model without the joints `removed` and what they carry; followers of a joint that goes stand on their own.
HandModel without_joints(const HandModel& model, const std::vector<bool>& removed) {
  HandModel rest = model;
  rest.tree.joints.clear();
  rest.links.clear();
  std::vector<int> new_joint, new_link;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    new_joint.push_back(removed[i] ? -1 : static_cast<int>(rest.tree.joints.size()));
    if (!removed[i]) rest.tree.joints.push_back(model.tree.joints[i]);
  }
  for (const ModelLink& link : model.links) {
    const bool goes = link.joint >= 0 && removed[link.joint];
    new_link.push_back(goes ? -1 : static_cast<int>(rest.links.size()));
    if (!goes) rest.links.push_back(link);
  }
  for (Joint& joint : rest.tree.joints) {
    if (joint.parent >= 0) joint.parent = new_joint[joint.parent];
    if (joint.mimic_master >= 0) joint.mimic_master = new_joint[joint.mimic_master];
  }
  for (ModelLink& link : rest.links) {
    if (link.joint >= 0) link.joint = new_joint[link.joint];
    if (link.parent_link >= 0) link.parent_link = new_link[link.parent_link];
  }
  return rest;
}

/// The hand with the fingers of the bit set `kept` alone.
HandModel with_fingers(const HandModel& model, const Anatomy& whole, unsigned kept) {
  std::vector<bool> removed(model.tree.joints.size(), false);
  const auto mark = [&](int finger, bool value) {
    for (const int joint : whole.fingers[finger].joints)
      for (std::size_t i = 0; i < removed.size(); ++i)
        if (model.tree.joints[i].name == whole.tree.joints[joint].name) removed[i] = value;
  };
  const int count = static_cast<int>(whole.fingers.size());
  for (int finger = 0; finger < count; ++finger)
    if ((kept >> finger & 1u) == 0) mark(finger, true);
  for (int finger = 0; finger < count; ++finger)
    if (kept >> finger & 1u) mark(finger, false);  // joints that both share stay
  return without_joints(model, removed);
}

double confidence_of_normal(const Anatomy& anatomy) {
  return std::ranges::find(anatomy.findings, kKey, &HandFinding::item)->confidence;
}

bool warns_of_normal(const Anatomy& anatomy) {
  return std::ranges::any_of(anatomy.warnings, [](const std::string& warning) {
    return warning.find('"' + std::string(kKey) + '"') != std::string::npos;
  });
}

}  // namespace

TEST_CASE("half of the fingers") {
  const HandModel model = load_hand_model(real_hand().urdf.string());
  const Anatomy whole = infer_anatomy(model);
  const double confidence_of_whole = confidence_of_normal(whole);
  const unsigned count = static_cast<unsigned>(whole.fingers.size());
  int halves = 0, doubted = 0;
  for (unsigned kept = 0; kept < 1u << count; ++kept) {
    const unsigned left = static_cast<unsigned>(std::popcount(kept));
    if (left < 2 || (left != count / 2 && left != count - count / 2)) continue;
    const Anatomy half = infer_anatomy(with_fingers(model, whole, kept));
    std::string fingers;
    for (const FingerAnatomy& finger : half.fingers) fingers += " " + half.tree.joints[finger.joints.front()].name;
    CAPTURE(fingers);
    const double error = std::acos(std::clamp(dot(half.palm_normal_root, whole.palm_normal_root), -1.0, 1.0));
    const double confidence = confidence_of_normal(half);
    std::cout << real_hand().name << ", left with" << fingers << ": normal turned by " << error / kDegree
              << " degrees, confidence " << confidence << '\n';
    CHECK(half.fingers.size() == left);
    CHECK(confidence < confidence_of_whole);
    CHECK((error < kNormalTolerance || confidence < 0.5));
    CHECK(warns_of_normal(half) == (confidence < 0.5));
    ++halves;
    doubted += confidence < 0.5 ? 1 : 0;
  }
  std::cout << real_hand().name << ": " << halves << " halves, " << doubted << " in doubt; whole "
            << confidence_of_whole << '\n';
}
