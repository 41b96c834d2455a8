#include "support/joint_truth.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace uhas::test {
namespace {

int joint_index(const HandModel& model, const std::string& name) {
  const auto& joints = model.tree.joints;
  return static_cast<int>(std::ranges::find(joints, name, &Joint::name) - joints.begin());
}

/// Value of `joint` when independent joints are at `q`.
double value_of(const HandModel& model, int joint, const std::vector<double>& q) {
  const Joint& j = model.tree.joints[joint];
  return j.mimic_master < 0 ? q[joint] : j.mimic_multiplier * q[j.mimic_master] + j.mimic_offset;
}

/// The frame of `joint`, behind its motion, in the root frame.
RigidTransformd frame_of(const HandModel& model, int joint, const std::vector<double>& q) {
  if (joint < 0) return {};
  const Joint& j = model.tree.joints[joint];
  const RigidTransformd motion{Rotationd::about(j.axis, value_of(model, joint, q)), {}};
  return frame_of(model, j.parent, q) * j.T_parent_joint * motion;
}

/// The fingertip in the root frame.
Vector3d tip_of(const HandModel& model, const RandomFinger& finger, const std::vector<double>& q) {
  return frame_of(model, joint_index(model, finger.joints.back()), q) * finger.p_tip_joint;
}

struct Speeds {
  double around = 0, squared = 0,
         relative = 0;  ///< squared speed around the normal; in all; speed per unit of distance
};

Speeds measure(const HandModel& model, const RandomHand& hand, int joint, Vector3d center, Vector3d normal,
               std::vector<double> q) {
  constexpr double h = 1e-6;
  Speeds speeds;
  int moved = 0;
  for (const RandomFinger& finger : hand.fingers) {
    std::vector<double> ahead = q;
    ahead[joint] += h;
    const Vector3d tip = tip_of(model, finger, q);
    const Vector3d speed = (tip_of(model, finger, ahead) - tip) / h;
    if (!(norm(speed) > 0)) continue;
    const Vector3d around = normalized(cross(normal, tip - center));
    speeds.around += std::pow(dot(speed, around), 2);
    speeds.squared += dot(speed, speed);
    int carrier = -1;  // the first of the finger's joints that turns with it
    for (const std::string& name : finger.joints) {
      const int other = joint_index(model, name);
      if (carrier < 0 && (other == joint || model.tree.joints[other].mimic_master == joint)) carrier = other;
    }
    speeds.relative += norm(speed) / norm(tip - frame_of(model, carrier, q).translation);
    ++moved;
  }
  if (moved > 0) speeds.relative /= moved;
  return speeds;
}

/// The hand open, with the flexion joints further out than `joint` at 30 % of their limits.
std::vector<double> flexed_beyond(const HandModel& model, const RandomHand& hand, int joint) {
  std::vector<double> q(model.tree.joints.size(), 0.0);
  for (const RandomFinger& finger : hand.fingers) {
    bool further_out = false;
    for (const std::string& name : finger.joints) {
      const int other = joint_index(model, name);
      const Joint& j = model.tree.joints[other];
      const bool own = other == joint || j.mimic_master == joint;
      if (further_out && !own && j.upper > 1)
        q[other] = 0.3 * j.upper;  // flexion joints close toward their upper limit
      further_out = further_out || own;
    }
  }
  return q;
}

}  // namespace

Vector3d palm_center(const HandModel& model, const RandomHand& hand) {
  const std::vector<double> q(model.tree.joints.size(), 0.0);
  Vector3d center;
  for (const RandomFinger& finger : hand.fingers)
    center += frame_of(model, joint_index(model, finger.joints.front()), q).translation /
              static_cast<double>(hand.fingers.size());
  return center;
}

Vector3d tip_at_zero(const HandModel& model, const RandomFinger& finger) {
  return tip_of(model, finger, std::vector<double>(model.tree.joints.size(), 0.0));
}

std::optional<JointClass> class_at_zero(const HandModel& model, const RandomHand& hand, const std::string& joint,
                                        Vector3d normal) {
  int index = joint_index(model, joint);
  if (model.tree.joints[index].mimic_master >= 0) index = model.tree.joints[index].mimic_master;
  const Joint& j = model.tree.joints[index];
  const Vector3d center = palm_center(model, hand);
  const auto class_in = [&](std::vector<double> q) -> std::optional<JointClass> {
    if (measure(model, hand, index, center, normal, q).relative < 0.02) return std::nullopt;
    const double first = std::max(j.lower, -0.5), last = std::min(j.upper, 0.5);
    constexpr int steps = 20;
    double share = 0;
    for (int k = 0; k <= steps; ++k) {
      q[index] = first + (last - first) * k / steps;
      const Speeds speeds = measure(model, hand, index, center, normal, q);
      share += speeds.squared > 0 ? speeds.around / speeds.squared / (steps + 1) : 0;
    }
    if (share > 0.6) return JointClass::lateral;
    if (share < 0.4) return JointClass::encompassing;
    return std::nullopt;
  };
  const std::vector<double> straight(model.tree.joints.size(), 0.0);
  const double relative = measure(model, hand, index, center, normal, straight).relative;
  const auto when_straight = class_in(straight), when_flexed = class_in(flexed_beyond(model, hand, index));
  if (relative < 0.2) return when_flexed;
  if (relative > 0.4 || when_straight == when_flexed) return when_straight;
  return std::nullopt;
}

}  // namespace uhas::test
