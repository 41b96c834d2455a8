#include "uhas/wrap/wrap.hpp"

#include <algorithm>
#include <numeric>

#include "uhas/kinematics/contact.hpp"
#include "uhas/kinematics/finger_groups.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {

SphereWrapper::SphereWrapper(const Anatomy& anatomy, const SphereFrame& frame,
                             std::span<const JointClassification> classes, std::span<const double> q_closed)
    : anatomy_(anatomy),
      frame_(frame),
      q_closed_(q_closed),
      T_sphere_palm_(frame.T_palm_sphere.inverse()),
      T_palm_joint_(anatomy.tree.joints.size()) {
  std::vector<std::vector<int>> finger_joints;
  for (const FingerAnatomy& finger : anatomy.fingers) finger_joints.push_back(finger.joints);
  std::vector<JointClass> joint_classes;
  for (const JointClassification& c : classes) joint_classes.push_back(c.joint_class);
  for (std::size_t i = 0; i < joint_classes.size(); ++i)
    if (joint_classes[i] == JointClass::encompassing) encompassing_.push_back(static_cast<int>(i));

  steps_ = plan_cascade(anatomy.tree, finger_joints, joint_classes, anatomy.q_open);
  std::vector<int> all_fingers(anatomy.fingers.size());
  std::iota(all_fingers.begin(), all_fingers.end(), 0);
  whole_hand_ = scope_of(all_fingers);

  // the fingertip depends on the finger's own unknowns and on those that these are solved with
  std::vector<std::vector<int>> unknowns(anatomy.fingers.size());
  for (const CascadeStep& step : steps_)
    for (int f : step.fingers) unknowns[f].push_back(step.joint);
  of_finger_.resize(anatomy.fingers.size());
  for (const std::vector<int>& group : group_fingers(unknowns))
    for (int f : group) of_finger_[f] = scope_of(group);
}

SphereWrapper::Scope SphereWrapper::scope_of(std::span<const int> fingers) const {
  Scope scope;
  for (const CascadeStep& step : steps_)
    if (std::ranges::find_first_of(step.fingers, fingers) != step.fingers.end()) scope.steps.push_back(&step);

  // the joints of these fingers, and all that carry them
  std::vector<bool> needed(anatomy_.tree.joints.size());
  for (int f : fingers) {
    for (int i : anatomy_.fingers[f].joints) needed[i] = true;
    if (const int tip = anatomy_.links[anatomy_.fingers[f].tip_link].joint; tip >= 0) needed[tip] = true;
  }
  for (std::size_t i = needed.size(); i-- > 0;)
    if (needed[i] && anatomy_.tree.joints[i].parent >= 0) needed[anatomy_.tree.joints[i].parent] = true;
  for (std::size_t i = 0; i < needed.size(); ++i)
    if (needed[i]) scope.joints.push_back(static_cast<int>(i));
  return scope;
}

void SphereWrapper::wrap(std::span<double> q) { wrap(whole_hand_, q); }

void SphereWrapper::wrap_finger(int finger, std::span<double> q) { wrap(of_finger_[finger], q); }

void SphereWrapper::wrap(const Scope& scope, std::span<double> q) {
  // from open, one unknown after the other, root to tip
  for (int i : encompassing_) q[i] = anatomy_.q_open[i];
  apply_mimics(anatomy_.tree, q);
  for (const CascadeStep* step : scope.steps)
    set_with_followers(anatomy_.tree, step->joint, wrapped_value(scope, *step, q), q);
}

double SphereWrapper::wrapped_value(const Scope& scope, const CascadeStep& step, std::span<double> q) {
  const Joint& joint = anatomy_.tree.joints[step.joint];
  const JointTravel<double> travel = travel_of(joint, anatomy_.q_open[step.joint], q_closed_[step.joint]);

  // one hinge with one node: the node's circle about the axis meets the sphere in closed form (docs/method.md#wrap)
  const bool single = step.driven.size() == 1 && step.driven.front() == step.joint;
  if (joint.kind != JointKind::prismatic && single && step.nodes.size() == 1) {
    set_with_followers(anatomy_.tree, step.joint, 0, q);
    place(scope, q);
    const RigidTransformd T = T_sphere_palm_ * T_palm_joint_[step.joint];
    const auto circle =
        Circle<double>::about(T.rotation * joint.axis, T.translation / frame_.radius, point(step.nodes[0]));
    return first_contact_with_sphere(circle, travel);
  }

  // coupled joints, shared ones and slides: the way is scanned for where the nodes lie on the sphere in the mean
  const auto mean_gap = [&](double value) {
    set_with_followers(anatomy_.tree, step.joint, value, q);
    place(scope, q);
    double sum = 0;
    for (const ContactNode& node : step.nodes) sum += norm(point(node)) - 1;
    return sum / static_cast<double>(step.nodes.size());
  };
  return first_contact_by_scan<double>(mean_gap, travel);
}

void SphereWrapper::place(const Scope& scope, std::span<const double> q) {
  forward_kinematics(anatomy_.tree, q, scope.joints, T_palm_joint_);
}

// point of `node` in S, sphere radii
Vector3d SphereWrapper::point(const ContactNode& node) const {
  const FingerAnatomy& finger = anatomy_.fingers[node.finger];
  const ProfileLink& tip = anatomy_.links[finger.tip_link];
  const Vector3d p_palm = node.joint >= 0 ? T_palm_joint_[node.joint].translation
                                          : T_palm_joint_[tip.joint] * (tip.T_joint_link * finger.p_tip_link);
  return (T_sphere_palm_ * p_palm) / frame_.radius;
}

void wrap_on_sphere(const Anatomy& anatomy, const SphereFrame& frame, std::span<const JointClassification> classes,
                    std::span<const double> q_closed, std::span<double> q) {
  SphereWrapper(anatomy, frame, classes, q_closed).wrap(q);
}

}  // namespace uhas
