#include "support/random_hand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "support/joint_truth.hpp"
#include "support/model_transforms.hpp"
#include "support/toy_hand.hpp"

namespace uhas::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// The palm's frame while the hand is made: normal +x, fingers along +z, the thumb's side +y; so a right hand,
// open at zero.
constexpr Vector3d kNormal{1, 0, 0}, kForward{0, 0, 1}, kThumbSide{0, 1, 0};

enum class Part { flexion, side, roll };  ///< about the axis across the finger, the closing direction, the finger's own

/// Of what a finger is made.
struct FingerDesign {
  std::vector<Part> parts;    ///< root to tip
  double length = 0.1;        ///< of the straight finger (m)
  double hyperextension = 0;  ///< how far the first flexion joint bends back (rad)
  double side_range = 0.4;    ///< to either side, about (rad)
  bool tip_frame = true, mesh = true;
  bool followers = false;  ///< flexion joints beyond the first mimic it
  int first_follows = -1;  ///< joint of another finger that the first flexion joint mimics
};

class HandMaker {
 public:
  explicit HandMaker(std::uint64_t seed) : random_(seed), toy_("random_hand_" + std::to_string(seed)) {}

  RandomHand make() {
    add_palm();
    const double kind = uniform(0, 1);
    if (kind < 0.7)
      add_row_and_thumb();
    else if (kind < 0.8)
      add_row();
    else
      add_gripper();
    add_decoys();
    hand_.model = toy_.take();
    find_classes();
    describe_anew();
    return std::move(hand_);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  static Vector3d turned(Vector3d v, Vector3d axis, double angle) {
    return Rotationd::about(normalized(axis), angle) * v;
  }

  static Joint hinge(Vector3d axis, double lower, double upper) {
    Joint joint;
    joint.axis = axis;
    joint.lower = lower;
    joint.upper = upper;
    return joint;
  }

  /// The palm under up to two wrist joints and some fixed links: a slab that lies as the hand does, or tilted, a block,
  /// or nothing; in one piece or two.
  void add_palm() {
    int link = 0;
    const int wrists = chance(0.3) ? pick(1, 2) : 0;
    for (int i = 0; i < wrists; ++i) {
      link = toy_.add_movable("forearm" + std::to_string(i), link, {{}, {0, 0, uniform(0.01, 0.1)}},
                              hinge(i == 0 ? kThumbSide : kNormal, -uniform(0.2, 0.8), uniform(0.2, 0.8)));
      if (chance(0.5)) toy_.add_box(link, {}, {0.05, 0.05, 0.05});
    }
    if (chance(0.5)) link = toy_.add_fixed("mount", link, {{}, {0, 0, 0.01}});
    palm_ = link;
    if (chance(0.2)) return;
    const Vector3d tilt_axis = normalized(Vector3d{0, uniform(-1, 1), uniform(-1, 1)});
    const double tilt = chance(0.2) ? uniform(-0.35, 0.35) : 0;
    const int body = tilt != 0 || chance(0.3)
                         ? toy_.add_fixed("body", palm_, {Rotationd::about(tilt_axis, tilt), {0, 0, 0.04}})
                         : palm_;
    const Vector3d center = body == palm_ ? Vector3d{0, 0, 0.04} : Vector3d{};
    const bool block = chance(0.2);
    toy_.add_box(body, center, {block ? uniform(0.05, 0.09) : uniform(0.015, 0.035), uniform(0.06, 0.1), 0.08});
    if (chance(0.2)) toy_.add_box(toy_.add_fixed("heel", palm_, {{}, {0.005, 0.02, 0.02}}), {}, {0.03, 0.03, 0.04});
  }

  std::vector<Part> random_parts(bool is_thumb) {
    constexpr std::array<int, 10> flexion_counts = {1, 2, 2, 2, 3, 3, 3, 3, 3, 4};
    const int flexions = flexion_counts[pick(0, 9)];
    std::vector<Part> parts(flexions, Part::flexion);
    const int others = std::min(chance(0.3) ? 0 : chance(0.85) ? 1 : 2, 5 - flexions);
    for (int i = 0; i < others; ++i) {
      const auto place = chance(0.6) ? 0 : chance(0.6) ? 1 : pick(0, static_cast<int>(parts.size()));
      parts.insert(parts.begin() + place, chance(is_thumb ? 0.5 : 0.1) ? Part::roll : Part::side);
    }
    return parts;
  }

  FingerDesign random_design() {
    FingerDesign design;
    design.parts = random_parts(false);
    design.length = uniform(0.07, 0.14);
    design.hyperextension = chance(0.85) ? uniform(0, 0.35) : uniform(0.35, 1.2);
    design.side_range = uniform(0.2, 0.7);
    design.mesh = hand_.has_surface = chance(0.8);
    design.tip_frame = !design.mesh || chance(0.5);
    design.followers = chance(0.2);
    return design;
  }

  /// Adds a finger on `carrier`, whose chain begins with the joints `shared`; returns its first flexion joint.
  int add_finger(const std::string& name, int carrier, Vector3d root, Vector3d direction, Vector3d closing,
                 const FingerDesign& design, const std::vector<std::string>& shared = {}) {
    const Vector3d axis = cross(direction, closing);
    RandomFinger finger;
    finger.joints = shared;
    int link = carrier, first_flexion = -1;
    RigidTransformd T_link_next = {{}, root};
    const auto add = [&](Vector3d a, double lower, double upper, int follows) {
      Joint joint = hinge(a, lower, upper);
      joint.mimic_master = follows;
      if (follows >= 0) joint.mimic_multiplier = uniform(0.6, 1.1);
      link = toy_.add_movable(name + std::to_string(finger.joints.size()), link, T_link_next, joint);
      finger.joints.push_back(toy_.model().tree.joints.back().name);
      T_link_next = {};
    };
    const auto add_bone = [&](double length) {
      if (!(length > 0)) return;
      const double thick = std::min(length, 0.07 * design.length);
      const Vector3d along = length * direction;
      if (design.mesh)
        toy_.add_box(link, T_link_next.translation + 0.5 * along, {length, thick, thick},
                     Rotationd::from_columns(direction, closing, cross(direction, closing)));
      T_link_next.translation = T_link_next.translation + along;
    };

    const auto flexions = std::count(design.parts.begin(), design.parts.end(), Part::flexion);
    std::vector<double> phalanges;
    double total = 0;
    for (int i = 0; i < flexions; ++i)
      phalanges.push_back(uniform(0.7, 1.3) / (1 + 0.4 * i)), total += phalanges.back();
    int bent = 0;
    double left_over = 0;  // of the phalanx behind a joint that splits it
    for (std::size_t i = 0; i < design.parts.size(); ++i) {
      if (design.parts[i] == Part::side) {
        add(closing, -design.side_range * uniform(0.7, 1), design.side_range * uniform(0.7, 1), -1);
      } else if (design.parts[i] == Part::roll) {
        add(direction, -design.side_range * uniform(0.7, 1), design.side_range * uniform(0.7, 1), -1);
      } else {
        add_bone(left_over);
        const int follows = bent == 0 ? design.first_follows : design.followers ? first_flexion : -1;
        add(axis, bent == 0 ? -design.hyperextension : -uniform(0, 0.25), uniform(1.2, 1.9), follows);
        if (bent == 0) first_flexion = follows >= 0 ? follows : static_cast<int>(toy_.model().tree.joints.size()) - 1;
        left_over = phalanges[bent++] / total * design.length;
        const bool splits = i + 1 < design.parts.size() && design.parts[i + 1] != Part::flexion;
        if (!splits) continue;
        const double before = (bent == flexions || chance(0.5) ? 0.1 : 0.9) * left_over;
        add_bone(before);
        left_over -= before;
      }
    }
    add_bone(left_over);
    finger.p_tip_joint = T_link_next.translation;
    if (design.tip_frame) toy_.add_fixed(name + "_end", link, T_link_next);
    if (chance(0.1)) toy_.add_fixed(name + "_sensor", link, {{}, 0.2 * T_link_next.translation + 0.003 * closing});
    if (chance(0.1)) {
      const Joint loose = hinge(closing, 0, 0.5);
      const int nail = toy_.add_movable(name + "_nail", link, {{}, 0.5 * T_link_next.translation}, loose);
      toy_.add_box(nail, {}, {0.002, 0.002, 0.002});
    }
    finger.classes.resize(finger.joints.size());
    hand_.fingers.push_back(finger);
    return first_flexion;
  }

  /// Two to four fingers side by side; returns their number.
  int add_fingers_in_row(int fingers, double spacing) {
    const FingerDesign common = random_design();
    const double splay = uniform(0, 0.12), arch = uniform(0, 0.006);
    const bool one_master = chance(0.05), own_designs = chance(0.15);
    const int on_arch = fingers >= 3 && chance(0.12) ? pick(1, 2) : 0;
    int metacarpal = -1, master = -1;
    for (int i = 0; i < fingers; ++i) {
      FingerDesign design = common;
      if (own_designs) design.parts = random_parts(false);
      design.length *= uniform(0.8, 1.1);
      if (one_master) design.first_follows = master;
      const double place = (fingers - 1) / 2.0 - i;
      const Vector3d direction = turned(kForward, kNormal, -splay * place);
      const Vector3d closing = turned(kNormal, direction, uniform(-0.1, 0.1));
      Vector3d root{-arch * place * place, spacing * place, 0.085 - uniform(0, 0.004) * place * place};
      int carrier = palm_;
      std::vector<std::string> shared;
      if (i >= fingers - on_arch) {
        const Vector3d p_arch{0, spacing * ((fingers - 1) / 2.0 - (fingers - on_arch)), 0.03};
        if (metacarpal < 0) metacarpal = toy_.add_movable("arch", palm_, {{}, p_arch}, hinge(kForward, -0.1, 0.4));
        carrier = metacarpal;
        shared = {"arch_joint"};
        root = root - p_arch;
      } else if (chance(0.15)) {
        const Vector3d p_knuckle{0, root.y, 0.07};
        carrier = toy_.add_fixed("knuckle" + std::to_string(i), palm_, {{}, p_knuckle});
        root = root - p_knuckle;
      }
      const int flexion =
          add_finger("finger" + std::to_string(i) + "_", carrier, root, direction, closing, design, shared);
      if (master < 0) master = flexion;
    }
    return fingers;
  }

  /// A thumb makes a hand of three fingers or more. It stands aside below the row, or straight against it.
  /// Truth: the hand is right or left when the open thumb's tip is 30 degrees or more from straight ahead and straight
  /// back of the palm's centre; else any answer will do, and so for the slots. A finger straight against two others may
  /// be called a thumb or not.
  void add_row_and_thumb() {
    const int fingers = pick(2, 4);
    const double spacing = uniform(0.018, 0.035);
    add_fingers_in_row(fingers, spacing);
    const bool against = chance(0.1);
    const double angle = against ? std::numbers::pi + uniform(-0.15, 0.15) : uniform(0.7, 1.9);
    const Vector3d direction =
        normalized(turned(turned(kForward, kNormal, -angle), kForward, against ? 0 : uniform(-0.2, 0.3)));
    FingerDesign design = random_design();
    design.parts = random_parts(true);
    design.followers = false;
    // a thumb that can roll is open where its pad faces the normal
    const bool can_roll = std::ranges::find(design.parts, Part::roll) != design.parts.end();
    const double roll = can_roll ? 0 : against ? uniform(-0.1, 0.1) : uniform(-0.5, 0.5);
    const Vector3d closing = normalized(orthogonal_part(turned(kNormal, direction, roll), direction));
    const Vector3d root =
        against ? Vector3d{0, uniform(-0.1, 0.1) * spacing, 0.02}
                : Vector3d{uniform(-0.015, 0.01), spacing * fingers / 2 * uniform(0.3, 0.9), uniform(0.0, 0.045)};
    add_finger("thumb_", palm_, root, direction, closing, design);

    hand_.normal_root = kNormal;
    if (!against || fingers > 2) hand_.has_thumb = true;
    const Vector3d to_tip = tip_at_zero(toy_.model(), hand_.fingers.back()) - palm_center(toy_.model(), hand_);
    const double azimuth = std::abs(std::atan2(to_tip.y, to_tip.z));
    if (std::min(azimuth, std::numbers::pi - azimuth) < 30 * kDegree) return;
    hand_.handedness = to_tip.y > 0 ? Handedness::right : Handedness::left;
    hand_.fingers.back().slot = 4;
    if (fingers >= 3)
      for (int i = 0; i < fingers; ++i) hand_.fingers[i].slot = 3 - i;
  }

  /// Without a thumb there is no handedness, and nothing says which end of the row comes first.
  void add_row() {
    add_fingers_in_row(pick(2, 5), uniform(0.018, 0.035));
    hand_.normal_root = kNormal;
    hand_.has_thumb = false;
    hand_.handedness = Handedness::none;
  }

  /// Two to five like fingers around the normal, open flat or nearly upright. Truth: neither thumb nor handedness;
  /// nothing says where slots begin.
  void add_gripper() {
    const int fingers = pick(2, 5);
    FingerDesign design = random_design();
    const double radius = uniform(0.02, 0.05), upright = chance(0.3) ? uniform(0.6, 1.4) : 0;
    if (upright > 0) design.hyperextension = 0;  // such fingers open no further
    for (int i = 0; i < fingers; ++i) {
      const double azimuth = 2 * std::numbers::pi * i / fingers + uniform(-0.08, 0.08);
      const Vector3d outward = turned(kForward, kNormal, azimuth);
      const Vector3d axis = cross(outward, kNormal);
      add_finger("finger" + std::to_string(i) + "_", palm_, radius * outward + 0.01 * kNormal,
                 turned(outward, axis, upright), turned(kNormal, axis, upright), design);
    }
    hand_.normal_root = kNormal;
    hand_.has_thumb = false;
    hand_.handedness = Handedness::none;
  }

  /// Leaves that are no fingers and no fingertips.
  void add_decoys() {
    if (chance(0.4)) {
      const int button = toy_.add_movable("button", palm_, {{}, {-0.02, 0.01, 0.04}}, hinge(kNormal, 0, 1));
      const double size = uniform(0.004, 0.012);
      toy_.add_box(button, {}, {size, size, size});
    }
    if (chance(0.4)) toy_.add_fixed("imu", palm_, {{}, {0.01, 0.02, 0.05}});
    if (chance(0.1)) {
      Joint follower = hinge(kThumbSide, 0, 2);
      follower.mimic_master = static_cast<int>(toy_.model().tree.joints.size()) - 1;
      while (toy_.model().tree.joints[follower.mimic_master].mimic_master >= 0) --follower.mimic_master;
      const int bar = toy_.add_movable("bar", palm_, {{}, {0.01, 0, 0.08}}, follower);
      toy_.add_box(bar, {0, 0, 0.01}, {0.004, 0.004, 0.02});
    }
  }

  void find_classes() {
    for (RandomFinger& finger : hand_.fingers)
      for (std::size_t i = 0; i < finger.joints.size(); ++i)
        finger.classes[i] = class_at_zero(hand_.model, hand_, finger.joints[i], kNormal);
  }

  /// Mirror, frames, axis signs, zeros, order, root frame: nothing that changes the hand.
  void describe_anew() {
    HandModel& model = hand_.model;
    if (chance(0.5)) {
      model = mirrored(std::move(model));
      hand_.normal_root.x = -hand_.normal_root.x;
      if (hand_.handedness && *hand_.handedness != Handedness::none)
        hand_.handedness = *hand_.handedness == Handedness::right ? Handedness::left : Handedness::right;
    }
    const std::size_t count = model.tree.joints.size();
    std::vector<bool> flipped(count);
    std::vector<double> offset(count, 0.0);
    // zeros as the designer left them, all fingers' at one curl, or each joint's anywhere
    const double zeros = uniform(0, 1), curl = uniform(-0.9, 0.9);
    for (std::size_t i = 0; i < count; ++i) {
      flipped[i] = chance(0.5);
      if (model.tree.joints[i].name.starts_with("forearm")) continue;  // the wrist stands at its zero
      if (zeros < 0.25)
        offset[i] = curl * uniform(0.8, 1.2);
      else if (zeros < 0.4)
        offset[i] = uniform(-0.9, 0.9);
    }
    model = with_moved_zeros(std::move(model), offset);
    model = with_flipped_axes(std::move(model), flipped);
    if (chance(0.5)) model = with_turned_frames(std::move(model), random_);
    if (chance(0.5)) model = with_reversed_siblings(model);
    const RigidTransformd T_new_old = random_pose(random_);
    model = with_moved_root(std::move(model), T_new_old);
    hand_.normal_root = T_new_old.rotation * hand_.normal_root;
  }

  std::mt19937_64 random_;
  ToyModel toy_;
  RandomHand hand_;
  int palm_ = 0;
};

}  // namespace

RandomHand make_random_hand(std::uint64_t seed) { return HandMaker(seed).make(); }

}  // namespace uhas::test
