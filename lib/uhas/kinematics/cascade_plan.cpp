#include "uhas/kinematics/cascade_plan.hpp"

#include <algorithm>

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// The first encompassing joint after position `from` of the finger whose origin is off the axis of `finger[from]`;
/// -1 when there is none. Joints that meet in one point do not move each other's origin.
int next_displaced_joint(const KinematicTree& tree, std::span<const int> finger, std::size_t from,
                         std::span<const JointClass> classes, std::span<const RigidTransformd> T_root_joint) {
  // the axis, and the length against which an arm is judged
  const RigidTransformd& T_axis = T_root_joint[finger[from]];
  const Vector3d axis = T_axis.rotation * tree.joints[finger[from]].axis;
  const double length = norm(T_root_joint[finger.back()].translation - T_axis.translation);

  // a shift moves every joint further out, a turn those that have an arm
  for (std::size_t i = from + 1; i < finger.size(); ++i) {
    if (classes[finger[i]] != JointClass::encompassing) continue;
    const Vector3d offset = T_root_joint[finger[i]].translation - T_axis.translation;
    constexpr double negligible_arm = 1e-3;  // of the distance to the last joint
    if (tree.joints[finger[from]].kind == JointKind::prismatic ||
        norm(orthogonal_part(offset, axis)) > negligible_arm * length)
      return finger[i];
  }
  return -1;
}

}  // namespace

std::vector<CascadeStep> plan_cascade(const KinematicTree& tree, std::span<const std::vector<int>> finger_joints,
                                      std::span<const JointClass> classes, std::span<const double> q) {
  // gather each unknown's joints and fingers; fingers in order and joints root to tip give the solving order
  std::vector<CascadeStep> steps;
  for (int f = 0; f < static_cast<int>(finger_joints.size()); ++f) {
    for (int joint : finger_joints[f]) {
      const int master = independent_joint(tree, joint);
      if (classes[master] != JointClass::encompassing) continue;
      auto step = std::find_if(steps.begin(), steps.end(), [&](const CascadeStep& s) { return s.joint == master; });
      if (step == steps.end())
        step = steps.insert(steps.end(), {.joint = master, .driven = {}, .fingers = {}, .nodes = {}});
      if (std::find(step->driven.begin(), step->driven.end(), joint) == step->driven.end())
        step->driven.push_back(joint);
      if (std::find(step->fingers.begin(), step->fingers.end(), f) == step->fingers.end()) step->fingers.push_back(f);
    }
  }

  // unknowns that move several fingers go before those fingers
  std::stable_partition(steps.begin(), steps.end(), [](const CascadeStep& s) { return s.fingers.size() > 1; });

  // the node of each step on each finger (docs/method.md#wrap): of a joint by itself the next one that it moves, of
  // coupled joints the fingertip
  std::vector<RigidTransformd> T_root_joint(tree.joints.size());
  forward_kinematics(tree, q, T_root_joint);
  for (CascadeStep& step : steps) {
    std::sort(step.driven.begin(), step.driven.end());
    for (int f : step.fingers) {
      ContactNode node{.finger = f, .joint = -1};
      if (step.driven.size() == 1) {
        const std::vector<int>& finger = finger_joints[f];
        const std::size_t at = std::find(finger.begin(), finger.end(), step.driven.front()) - finger.begin();
        node.joint = next_displaced_joint(tree, finger, at, classes, T_root_joint);
      }
      step.nodes.push_back(node);
    }
  }
  return steps;
}

}  // namespace uhas
