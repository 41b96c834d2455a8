// The rule `contact` (docs/method.md#contact): definitions of Cascade for plain numbers, one hand at a time.
#pragma once

#include <algorithm>
#include <cmath>

#include "uhas/kinematics/contact.hpp"
#include "uhas/runtime/cascade/cascade.hpp"

namespace uhas {

/// origin of the node's joint, or the fingertip, in `joint`'s frame with `joint` itself at zero
template <class Num, class Visit>
Vector3<Num> Cascade<Num, Visit>::node_in_frame(const Model& model, const ContactNode& node, int joint) const noexcept {
  // from the node's own frame inward, joint by joint
  int at = node.joint >= 0 ? node.joint : model.tips[node.finger].joint;
  Vector3<Num> p = node.joint >= 0 ? Vector3<Num>{} : model.tips[node.finger].p;
  while (at != joint && at >= 0) {
    const SolverJoint<Real>& j = model.joints[at];
    p = j.moved(j.T_parent_joint, joints_[at].value) * p;
    at = j.parent;
  }
  return p;
}

/// Signed distance of a point from the deformed profile of `plane`, sphere radii.
template <class Real>
Real gap_to_profile(const PlaneDeformation<Real>& plane, Vector3<Real> p) {
  const Real phi = atan2(sqrt(p.x * p.x + p.y * p.y), -p.z);
  return norm(p) - std::max(Real(1) + plane.at(phi).delta_r, Real(0));
}

/// turn from open until the node meets the profile of its finger's plane
template <class Num, class Visit>
Num Cascade<Num, Visit>::contact_single(const Model& model, const SolverStep& step,
                                        const RigidTransform<Num>& F) noexcept {
  const SolverJoint<Real>& joint = model.joints[step.joint];
  if (joint.prismatic || step.nodes.size() != 1) return contact_group(model, step);
  // the node runs on a circle about the joint's axis, in the plane of its finger
  const ContactNode& node = step.nodes[0];
  const PlaneDeformation<Num>& plane = plane_of(model, node.finger);
  const Circle<Num> circle =
      Circle<Num>::about(F.rotation.column(2), F.translation, F * node_in_frame(model, node, step.joint));
  // a profile without deformation is a sphere, whose meeting has a closed form
  const bool undeformed =
      std::all_of(plane.delta_r.begin(), plane.delta_r.begin() + plane.vectors, [](Real d) { return d == Real(0); });
  if (undeformed) return first_contact_with_sphere(circle, joint.travel);
  return first_contact_by_scan<Num>([&](Num t) { return gap_to_profile(plane, circle.at(t)); }, joint.travel);
}

/// the same for coupled joints, several fingers and sliding joints: the nodes' mean gap decides
template <class Num, class Visit>
Num Cascade<Num, Visit>::contact_group(const Model& model, const SolverStep& step) noexcept {
  const JointValue<Num> present = joints_[step.joint].value;
  // the mean distance of the nodes from their profiles, everything that the step moves moved
  const auto mean_gap = [&](Num value) {
    set_unknown(model, step, model.joints[step.joint].value(value));
    move_frames(model, step.scope);
    Num sum = 0;
    for (const ContactNode& node : step.nodes) {
      const Vector3<Num> p = node.joint >= 0
                                 ? joints_[node.joint].T_S_moved.translation
                                 : joints_[model.tips[node.finger].joint].T_S_moved * model.tips[node.finger].p;
      sum += gap_to_profile(plane_of(model, node.finger), p);
    }
    return sum / Real(step.nodes.size());
  };
  const Num found = first_contact_by_scan<Num>(mean_gap, model.joints[step.joint].travel);
  // the scan has moved the joints: back to where they stood
  set_unknown(model, step, present);
  return found;
}

}  // namespace uhas
