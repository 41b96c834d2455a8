// Random hands that know their own anatomy.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/model_transforms.hpp"
#include "support/toy_hand.hpp"

namespace uhas::test {

struct RandomHand {
  HandModel model;
  std::vector<std::vector<std::string>> chains;  ///< joints of each finger, root to tip; the thumb last
  Vector3d normal_root;                          ///< outward palm normal in the root frame
  Handedness handedness = Handedness::none;
  bool has_thumb = false;
  bool has_surface = true;  ///< the fingers have meshes
  std::vector<int> slots;  ///< one a finger: a slot that it owns for certain, or -1
};

class RandomHandMaker {
 public:
  explicit RandomHandMaker(std::uint64_t seed) : random_(seed), toy_("random_hand_" + std::to_string(seed)) {}

  /// A thumb and two to four fingers, or a gripper of three; right or left; placed, turned and named at random.
  RandomHand make() {
    palm_ = add_palm();
    hand_.has_thumb = chance(0.85);
    if (hand_.has_thumb)
      add_row_and_thumb();
    else
      add_gripper();
    add_decoys();
    hand_.model = toy_.take();
    rename_and_disguise();
    return std::move(hand_);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  static Vector3d turned(Vector3d v, Vector3d axis, double angle) {
    return Rotationd::about(normalized(axis), angle) * v;
  }

  Joint hinge(Vector3d axis, double lower, double upper) {
    Joint joint;
    joint.axis = axis;
    joint.lower = lower;
    joint.upper = upper;
    return joint;
  }

  /// The palm under up to two wrist joints and a fixed link or two.
  int add_palm() {
    int link = 0;
    const int wrists = chance(0.3) ? pick(1, 2) : 0;
    for (int i = 0; i < wrists; ++i) {
      link = toy_.add_movable(
          "forearm" + std::to_string(i), link, {{}, {0, 0, uniform(0.01, 0.1)}},
          hinge(i == 0 ? Vector3d{0, 1, 0} : Vector3d{1, 0, 0}, -uniform(0.2, 0.8), uniform(0.2, 0.8)));
      if (chance(0.5)) toy_.add_box(link, {}, {0.05, 0.05, 0.05});
    }
    if (chance(0.5)) link = toy_.add_fixed("mount", link, {{}, {0, 0, 0.01}});
    if (chance(0.7)) toy_.add_box(link, {0, 0, 0.04}, {0.025, 0.085, 0.08});
    return link;
  }

  /// Adds the joints and links of a finger whose side joint may come after the first flexion joint.
  void add_finger(const std::string& name, Vector3d root, Vector3d direction, Vector3d closing, int flexions,
                  double length, int side, double hyperextension, bool tip_frame, bool meshes, bool followers) {
    const Vector3d axis = cross(direction, closing);
    std::vector<std::string> chain;
    int link = palm_, part = 0, master = -1;
    RigidTransformd T_next = {{}, root};
    const auto add = [&](Vector3d a, double lower, double upper, int follows) {
      Joint joint = hinge(a, lower, upper);
      joint.mimic_master = follows;
      if (follows >= 0) joint.mimic_multiplier = 0.8;
      link = toy_.add_movable(name + std::to_string(part++), link, T_next, joint);
      chain.push_back(name + std::to_string(part - 1) + "_joint");
      T_next = {};
    };
    std::vector<double> phalanges;
    double total = 0;
    for (int i = 0; i < flexions; ++i)
      phalanges.push_back(uniform(0.7, 1.3) / (1 + 0.4 * i)), total += phalanges.back();
    if (side == 1) add(closing, -uniform(0.2, 0.5), uniform(0.2, 0.5), -1);
    if (side == 3) add(direction, -uniform(0.3, 0.5), uniform(0.3, 0.5), -1);
    for (int i = 0; i < flexions; ++i) {
      const double phalanx = phalanges[i] / total * length;
      add(axis, i == 0 ? -hyperextension : -uniform(0, 0.25), uniform(1.2, 1.9), followers && i > 0 ? master : -1);
      if (i == 0) {
        master = static_cast<int>(toy_.model().tree.joints.size()) - 1;
        if (side == 2) T_next = {{}, 0.1 * length * direction}, add(closing, -uniform(0.2, 0.5), uniform(0.2, 0.5), -1);
      }
      const double thick = 0.2 * phalanx;
      if (meshes)
        toy_.add_box(link, phalanx / 2 * direction,
                     Vector3d{thick, thick, thick} + (phalanx - thick) * absolute(direction));
      T_next = {{}, phalanx * direction};
    }
    if (tip_frame || !meshes) toy_.add_fixed(name + "_end", link, T_next);
    hand_.chains.push_back(chain);
  }

  static Vector3d absolute(Vector3d v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

  /// In the palm's frame: normal +x, fingers along +z, the thumb's side +y, so a right hand.
  void add_row_and_thumb() {
    const Vector3d n{1, 0, 0}, forward{0, 0, 1};
    const int fingers = pick(2, 4), flexions = pick(1, 4), side = pick(0, flexions > 1 ? 2 : 1);
    const double length = uniform(0.07, 0.14), spacing = uniform(0.018, 0.035), splay = uniform(0, 0.12);
    const double hyperextension = uniform(0, 0.35), arch = uniform(0, 0.006);
    const bool tips = chance(0.5), meshes = chance(0.8), followers = flexions > 1 && chance(0.2);
    hand_.has_surface = meshes;
    for (int i = 0; i < fingers; ++i) {
      const double place = (fingers - 1) / 2.0 - i;
      const Vector3d direction = turned(forward, n, -splay * place);
      const Vector3d closing = turned(n, direction, uniform(-0.1, 0.1));
      const Vector3d root{-arch * place * place, spacing * place, 0.085 - uniform(0, 0.004) * place * place};
      add_finger("finger" + std::to_string(i) + "_", root, direction, closing, flexions, length * uniform(0.85, 1.1),
                 side, hyperextension, tips, meshes, followers);
      hand_.slots.push_back(fingers >= 3 ? 3 - i : -1);
    }
    // The thumb stands aside below the index finger and bends toward the normal, once rolled.
    const Vector3d direction = normalized(turned(turned(forward, n, -uniform(0.9, 1.6)), forward, uniform(-0.2, 0.3)));
    const Vector3d closing = normalized(orthogonal_part(turned(n, direction, uniform(-0.5, 0.5)), direction));
    const Vector3d root{uniform(-0.015, 0.01), spacing * fingers / 2 * uniform(0.3, 0.9), uniform(0.0, 0.045)};
    const int thumb_side = chance(0.5) ? 3 : pick(0, 3);
    add_finger("thumb_", root, direction, closing, std::max(2, pick(flexions - 1, flexions)),
               length * uniform(0.7, 1.0), thumb_side, uniform(0, 0.35), tips, meshes, false);
    hand_.slots.push_back(4);
    hand_.handedness = Handedness::right;
    hand_.normal_root = n;
  }

  /// Three like fingers around x.
  void add_gripper() {
    const double radius = uniform(0.02, 0.05), length = uniform(0.07, 0.14), hyperextension = uniform(0, 0.35);
    const int flexions = pick(1, 3), side = pick(0, 1);
    for (int i = 0; i < 3; ++i) {
      const Vector3d direction = turned({0, 0, 1}, {1, 0, 0}, 2 * std::numbers::pi / 3 * i);
      add_finger("finger" + std::to_string(i) + "_", radius * direction, direction, {1, 0, 0}, flexions, length, side,
                 hyperextension, true, true, false);
      hand_.slots.push_back(-1);
    }
    hand_.normal_root = {1, 0, 0};
  }

  /// Small movable and fixed leaves that are no fingers and no fingertips.
  void add_decoys() {
    if (chance(0.4)) {
      const int button = toy_.add_movable("button", palm_, {{}, {-0.02, 0.01, 0.04}}, hinge({1, 0, 0}, 0, 1));
      toy_.add_box(button, {}, {0.006, 0.006, 0.006});
    }
    if (chance(0.4)) toy_.add_fixed("imu", palm_, {{}, {0.01, 0.02, 0.05}});
  }

  /// Mirror, names, axis signs, zeros, root frame: nothing that changes the hand.
  void rename_and_disguise() {
    HandModel& model = hand_.model;
    if (chance(0.5)) {
      model = mirrored(std::move(model));
      hand_.normal_root.x = -hand_.normal_root.x;
      if (hand_.handedness == Handedness::right) hand_.handedness = Handedness::left;
    }
    std::vector<bool> flipped(model.tree.joints.size());
    std::vector<double> offset(model.tree.joints.size(), 0.0);
    const bool moved_zeros = chance(0.4);
    const double curled = uniform(-0.9, 0.9);
    for (std::size_t i = 0; i < flipped.size(); ++i) {
      flipped[i] = chance(0.5);
      if (moved_zeros && !model.tree.joints[i].name.starts_with("forearm")) offset[i] = curled * uniform(0.8, 1.2);
    }
    model = with_moved_zeros(std::move(model), offset);
    model = with_flipped_axes(std::move(model), flipped);
    if (chance(0.5)) model = with_reversed_siblings(model);
    const RigidTransformd T_new_old = random_pose(random_);
    // the wrist, at its clipped zero, turns nothing: its limits hold zero
    model = with_moved_root(std::move(model), T_new_old);
    hand_.normal_root = T_new_old.rotation * hand_.normal_root;
  }

  std::mt19937_64 random_;
  ToyModel toy_;
  RandomHand hand_;
  int palm_ = 0;
};

}  // namespace uhas::test
