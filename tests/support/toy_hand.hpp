// Small hands built in code, whose anatomy is known by construction. In the frame of the palm link, at q = 0, a finger
// is straight along `direction` and closes toward `closing`.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas::test {

struct ToyFinger {
  std::string name{};
  Vector3d root{};                                  ///< origin of the first joint, palm frame (m)
  Vector3d direction{0, 0, 1}, closing{1, 0, 0};    ///< unit, orthogonal
  std::vector<double> phalanges{0.05, 0.03, 0.02};  ///< lengths (m); one flexion joint each
  double side_range = 0.3;      ///< of a side joint about `closing` before the flexion joints; 0 = none
  double roll_range = 0;        ///< of a roll joint about `direction` before the flexion joints; 0 = none
  double hyperextension = 0.2;  ///< how far the first flexion joint bends back (rad)
  double flexion = 1.6;         ///< how far each flexion joint closes (rad)
  bool tip_frame = true;        ///< a link without geometry at the fingertip
  bool followers = false;       ///< flexion joints beyond the first mimic it
};

/// Adds links and joints to a model; parents first, as the loader does.
class ToyModel {
 public:
  explicit ToyModel(std::string name) {
    model_.name = std::move(name);
    model_.links.push_back({"root", -1, -1, {}, {}});
  }

  /// A link fixed to `parent_link`; returns its index.
  int add_fixed(const std::string& name, int parent_link, const RigidTransformd& T_parent_link) {
    const ModelLink& parent = model_.links[parent_link];
    model_.links.push_back({name, parent_link, parent.joint, parent.T_joint_link * T_parent_link, {}});
    return static_cast<int>(model_.links.size()) - 1;
  }

  /// A link on a new joint `joint`, whose name, parent and transform are filled in; returns the link's index.
  int add_movable(const std::string& name, int parent_link, const RigidTransformd& T_parent_joint, Joint joint) {
    const ModelLink& parent = model_.links[parent_link];
    joint.name = name + "_joint";
    joint.parent = parent.joint;
    joint.T_parent_joint = parent.T_joint_link * T_parent_joint;
    model_.tree.joints.push_back(joint);
    model_.links.push_back({name, parent_link, static_cast<int>(model_.tree.joints.size()) - 1, {}, {}});
    return static_cast<int>(model_.links.size()) - 1;
  }

  /// Adds a box, turned by `rotation`, to the mesh of `link`.
  void add_box(int link, Vector3d center, Vector3d size, const Rotationd& rotation = {}) {
    TriangleMesh& mesh = model_.links[link].mesh;
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < 8; ++i)
      mesh.vertices.push_back(center + rotation * Vector3d{(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y,
                                                           (i & 4 ? 0.5 : -0.5) * size.z});
    constexpr std::uint32_t faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (const auto& face : faces) mesh.triangles.push_back({base + face[0], base + face[1], base + face[2]});
  }

  /// A finger on `palm_link`; returns its joints, root to tip.
  std::vector<int> add_finger(int palm_link, const ToyFinger& finger) {
    std::vector<int> joints;
    int link = palm_link;
    RigidTransformd T_link_next = {{}, finger.root};
    const auto add = [&](const std::string& part, Vector3d axis, double lower, double upper, int master = -1) {
      Joint joint;
      joint.axis = axis;
      joint.lower = lower;
      joint.upper = upper;
      joint.mimic_master = master;
      link = add_movable(finger.name + part, link, T_link_next, joint);
      joints.push_back(model_.links[link].joint);
      T_link_next = {};
    };
    if (finger.side_range > 0) add("_side", finger.closing, -finger.side_range, finger.side_range);
    if (finger.roll_range > 0) add("_roll", finger.direction, -finger.roll_range, finger.roll_range);
    int master = -1;
    for (std::size_t i = 0; i < finger.phalanges.size(); ++i) {
      const double length = finger.phalanges[i];
      add("_" + std::to_string(i + 1), cross(finger.direction, finger.closing), i == 0 ? -finger.hyperextension : 0,
          finger.flexion, finger.followers ? master : -1);
      if (i == 0) master = joints.back();
      const double thickness = 0.25 * length;
      const Vector3d along{std::abs(finger.direction.x), std::abs(finger.direction.y), std::abs(finger.direction.z)};
      add_box(link, length / 2 * finger.direction,
              (length - thickness) * along + Vector3d{thickness, thickness, thickness});
      T_link_next = {{}, length * finger.direction};
    }
    if (finger.tip_frame) add_fixed(finger.name + "_tip", link, T_link_next);
    return joints;
  }

  const HandModel& model() const { return model_; }
  HandModel take() { return std::move(model_); }

 private:
  HandModel model_;
};

struct ToyHandOptions {
  int fingers = 4;     ///< beside the thumb, 2 to 4: index, middle, ring, pinky
  bool wrist = false;  ///< a wrist joint above the palm
  ToyFinger finger{};  ///< what the fingers have in common
  ToyFinger thumb{.direction = {0, 1, 0}, .side_range = 0, .roll_range = 0.4};
};

/// A right hand in the plane of y and z: palm normal +x, fingers along +z, thumb along +y below the index finger.
inline HandModel make_toy_hand(const ToyHandOptions& options = {}) {
  constexpr double spacing = 0.022;
  ToyModel toy("toy_hand");
  int base = 0;
  if (options.wrist) {
    Joint wrist;
    wrist.axis = {0, 1, 0};
    wrist.lower = -0.5;
    wrist.upper = 0.5;
    base = toy.add_movable("forearm", 0, {{}, {0, 0, -0.05}}, wrist);
  }
  const int palm = toy.add_fixed("palm", base, {{}, {0, 0, 0.02}});
  toy.add_box(palm, {0, 0, 0.04}, {0.02, 0.08, 0.08});
  constexpr const char* names[] = {"index", "middle", "ring", "pinky"};
  for (int i = 0; i < options.fingers; ++i) {
    ToyFinger finger = options.finger;
    finger.name = names[i];
    finger.root = {0, (1 - i) * spacing, 0.085};
    toy.add_finger(palm, finger);
  }
  ToyFinger thumb = options.thumb;
  thumb.name = "thumb";
  thumb.root = {0, 0.03, 0.02};
  toy.add_finger(palm, thumb);
  return toy.take();
}

/// A gripper whose fingers stand around +z and close over it; no thumb, no handedness.
inline HandModel make_toy_gripper(int fingers = 3) {
  ToyModel toy("toy_gripper");
  for (int i = 0; i < fingers; ++i) {
    const double azimuth = 2 * std::numbers::pi * i / fingers;
    ToyFinger finger;
    finger.name = "finger" + std::to_string(i + 1);
    finger.direction = {std::cos(azimuth), std::sin(azimuth), 0};
    finger.closing = {0, 0, 1};
    finger.root = 0.03 * finger.direction;
    finger.side_range = 0;
    toy.add_finger(0, finger);
  }
  return toy.take();
}

/// Two jaws that slide along y toward each other; they reach along +z.
inline HandModel make_toy_parallel_gripper() {
  ToyModel toy("toy_parallel_gripper");
  for (const double side : {-1.0, 1.0}) {
    Joint slide;
    slide.kind = JointKind::prismatic;
    slide.axis = {0, side, 0};
    slide.upper = 0.04;
    const int jaw = toy.add_movable(side < 0 ? "left_jaw" : "right_jaw", 0, {{}, {0, side * 0.005, 0.06}}, slide);
    toy.add_box(jaw, {0, side * 0.005, 0.03}, {0.02, 0.01, 0.06});
  }
  return toy.take();
}

}  // namespace uhas::test
