#include "uhas/classification/joint_classes.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/base/spherical.hpp"
#include "uhas/classification/finger_sweep.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// What a sweep makes of a fingertip: travel across the sphere, travel in radius and polar angle, path length
/// (m); range swept.
struct Travel {
  double lateral = 0, encompassing = 0, path = 0, range = 0;
};

/// Sweeps `joint` 0.5 rad (a sliding joint half a sphere radius) to both sides of open, from the pose `q`.
Travel sweep(const Anatomy& anatomy, const SphereFrame& frame, int joint, std::vector<double> q) {
  constexpr int steps = 200;
  const Joint& j = anatomy.tree.joints[joint];
  const double half_range = j.kind == JointKind::prismatic ? 0.5 * frame.radius : 0.5;
  const double first = std::max(anatomy.q_open[joint] - half_range, j.lower);
  const double last = std::min(anatomy.q_open[joint] + half_range, j.upper);

  Travel travel{.range = last - first};
  for (int f : fingers_moved(anatomy, joint)) {
    Vector3d before;
    for (int k = 0; k <= steps; ++k) {
      set_with_followers(anatomy.tree, joint, first + (last - first) * k / steps, q);
      const Vector3d tip = fingertip_in_sphere(anatomy, frame, f, q);
      if (k > 0) {
        // the step's parts as lengths: r sin(phi) |d theta| across the sphere, sqrt(dr^2 + (r d phi)^2) in radius and
        // polar angle, with r and phi in the middle of the step
        const Spherical<double> a = to_spherical(before), b = to_spherical(tip);
        const double middle_radius = (a.radius + b.radius) / 2, middle_polar = (a.polar + b.polar) / 2;
        travel.lateral += middle_radius * std::sin(middle_polar) * std::abs(wrap_angle(b.azimuth - a.azimuth));
        travel.encompassing += std::hypot(b.radius - a.radius, middle_radius * (b.polar - a.polar));
        travel.path += norm(tip - before);
      }
      before = tip;
    }
  }
  return travel;
}

/// Sum over the moved fingers of the distance from the joint to the fingertip at the open pose (m).
double total_arm(const Anatomy& anatomy, const SphereFrame& frame, int joint) {
  std::vector<RigidTransformd> T_palm_joint(anatomy.tree.joints.size());
  forward_kinematics(anatomy.tree, anatomy.q_open, T_palm_joint);
  double arm = 0;
  for (int f : fingers_moved(anatomy, joint)) {
    const std::vector<int>& joints = anatomy.fingers[f].joints;
    const int first =
        *std::find_if(joints.begin(), joints.end(), [&](int i) { return turns_with(anatomy.tree, i, joint); });
    const Vector3d tip = frame.T_palm_sphere * fingertip_in_sphere(anatomy, frame, f, anatomy.q_open);
    arm += norm(tip - T_palm_joint[first].translation);
  }
  return arm;
}

/// @param classes  of the joints further out
JointClassification classify(const Anatomy& anatomy, const SphereFrame& frame, std::span<const double> q_closed,
                             int joint, std::span<const JointClassification> classes) {
  JointClassification result;
  Travel travel = sweep(anatomy, frame, joint, anatomy.q_open);

  // an axis that points at the fingertip hardly moves it: bend the finger and look again
  constexpr double pointing_at_tip = 0.3, flexed_share = 0.3;
  if (anatomy.tree.joints[joint].kind != JointKind::prismatic &&
      travel.path < pointing_at_tip * total_arm(anatomy, frame, joint) * travel.range) {
    std::vector<double> q = anatomy.q_open;
    for (int f : fingers_moved(anatomy, joint))
      for (int i : joints_further_out(anatomy, f, joint))
        if (classes[i].joint_class == JointClass::encompassing)
          q[i] = anatomy.q_open[i] + flexed_share * (q_closed[i] - anatomy.q_open[i]);
    apply_mimics(anatomy.tree, q);
    travel = sweep(anatomy, frame, joint, q);
    result.flexed_probe = true;
  }

  // the larger part of the travel is the class; the margin says by how much
  result.lateral_motion = travel.lateral;
  result.encompassing_motion = travel.encompassing;
  // a fingertip on the joint's axis goes nowhere, and what rounding makes of that is no class
  constexpr double standing_still = 0.005;  // radii
  const double total = travel.lateral + travel.encompassing;
  if (total <= standing_still * frame.radius) return result;
  result.margin = std::abs(travel.lateral - travel.encompassing) / total;
  result.joint_class = travel.lateral > travel.encompassing ? JointClass::lateral : JointClass::encompassing;
  return result;
}

}  // namespace

std::vector<JointClassification> classify_joints(const Anatomy& anatomy, const SphereFrame& frame,
                                                 std::span<const double> q_closed) {
  const int count = static_cast<int>(anatomy.tree.joints.size());
  std::vector<JointClassification> classes(count);
  for (int i = count - 1; i >= 0; --i)  // from the fingertips inward
    if (anatomy.tree.joints[i].mimic_master < 0) classes[i] = classify(anatomy, frame, q_closed, i, classes);
  for (int i = 0; i < count; ++i)
    if (anatomy.tree.joints[i].mimic_master >= 0) classes[i] = classes[anatomy.tree.joints[i].mimic_master];
  return classes;
}

}  // namespace uhas
