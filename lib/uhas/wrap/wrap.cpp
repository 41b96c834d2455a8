#include "uhas/wrap/wrap.hpp"

#include <algorithm>
#include <vector>

#include "uhas/runtime/cascade_plan.hpp"
#include "uhas/runtime/contact.hpp"
#include "uhas/runtime/forward_kinematics.hpp"

namespace uhas {
namespace {

/// The hand in sphere radii while it is wrapped joint by joint.
class Wrapping {
 public:
  Wrapping(const Anatomy& anatomy, const SphereFrame& frame, std::span<double> q)
      : anatomy_(anatomy), frame_(frame), q_(q), T_palm_joint_(q.size()) {}

  void place(const CascadeStep& step, double q_closed) {
    const Joint& joint = anatomy_.tree.joints[step.joint];
    const bool closes_upward = joint.upper - q_closed <= q_closed - joint.lower;
    const JointTravel<double> travel{anatomy_.q_open[step.joint], q_closed, closes_upward ? joint.lower : joint.upper};

    const bool circle = joint.kind != JointKind::prismatic && step.driven.size() == 1 && step.driven.front() == step.joint &&
                        step.nodes.size() == 1;
    set(step.joint, circle ? first_contact_with_sphere(circle_of(step), travel)
                           : first_contact_by_scan<double>([&](double t) { return mean_gap(step, t); }, travel));
  }

 private:
  void set(int joint, double value) {
    q_[joint] = value;
    apply_mimics(anatomy_.tree, q_);
  }

  /// Point of `node` in S, sphere radii.
  Vector3d point(const ContactNode& node) const {
    const FingerAnatomy& finger = anatomy_.fingers[node.finger];
    const ProfileLink& tip = anatomy_.links[finger.tip_link];
    const Vector3d p_palm = node.joint >= 0 ? T_palm_joint_[node.joint].translation
                                            : T_palm_joint_[tip.joint] * (tip.T_joint_link * finger.p_tip_link);
    return (frame_.T_palm_sphere.inverse() * p_palm) / frame_.radius;
  }

  Circle<double> circle_of(const CascadeStep& step) {
    set(step.joint, 0);
    forward_kinematics(anatomy_.tree, q_, T_palm_joint_);
    const RigidTransformd T = frame_.T_palm_sphere.inverse() * T_palm_joint_[step.joint];
    return Circle<double>::about(T.rotation * anatomy_.tree.joints[step.joint].axis, T.translation / frame_.radius,
                                 point(step.nodes[0]));
  }

  double mean_gap(const CascadeStep& step, double value) {
    set(step.joint, value);
    forward_kinematics(anatomy_.tree, q_, T_palm_joint_);
    double sum = 0;
    for (const ContactNode& node : step.nodes) sum += norm(point(node)) - 1;
    return sum / static_cast<double>(step.nodes.size());
  }

  const Anatomy& anatomy_;
  const SphereFrame& frame_;
  std::span<double> q_;
  std::vector<RigidTransformd> T_palm_joint_;
};

}  // namespace

void wrap_on_sphere(const Anatomy& anatomy, const SphereFrame& frame, std::span<const JointClassification> classes,
                    std::span<const double> q_closed, std::span<double> q) {
  std::vector<std::vector<int>> finger_joints;
  for (const FingerAnatomy& finger : anatomy.fingers) finger_joints.push_back(finger.joints);
  std::vector<JointClass> joint_classes;
  for (const JointClassification& c : classes) joint_classes.push_back(c.joint_class);

  for (std::size_t i = 0; i < q.size(); ++i)
    if (joint_classes[i] == JointClass::encompassing) q[i] = anatomy.q_open[i];
  apply_mimics(anatomy.tree, q);
  Wrapping wrapping(anatomy, frame, q);
  for (const CascadeStep& step : plan_cascade(anatomy.tree, finger_joints, joint_classes, anatomy.q_open))
    wrapping.place(step, q_closed[step.joint]);
}

}  // namespace uhas
