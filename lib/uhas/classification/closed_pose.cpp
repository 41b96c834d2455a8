#include "uhas/classification/closed_pose.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/classification/finger_sweep.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// Least distance of the moved fingertips (their mean) from the sphere's centre while `joint` goes from open to
/// `end`, in radii.
double least_distance(const Anatomy& anatomy, const SphereFrame& frame, int joint, double end) {
  constexpr int steps = 64;
  const std::vector<int> fingers = fingers_moved(anatomy, joint);
  std::vector<double> q = anatomy.q_open;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= steps; ++k) {
    set_with_followers(anatomy.tree, joint, anatomy.q_open[joint] + (end - anatomy.q_open[joint]) * k / steps, q);
    double sum = 0;
    for (int f : fingers) sum += norm(fingertip_in_sphere(anatomy, frame, f, q)) / frame.radius;
    least = std::min(least, sum / static_cast<double>(fingers.size()));
  }
  return least;
}

/// The end of a positive turn about the way from the sphere's centre to the open fingertips (on a left hand of a
/// negative one, its mirror image): the same end whichever sign the joint's axis has.
double conventional_end(const Anatomy& anatomy, const SphereFrame& frame, int joint) {
  const Joint& j = anatomy.tree.joints[joint];
  std::vector<RigidTransformd> T_palm_joint(anatomy.tree.joints.size());
  forward_kinematics(anatomy.tree, anatomy.q_open, T_palm_joint);
  const Vector3d axis = frame.T_palm_sphere.rotation.transposed() * (T_palm_joint[joint].rotation * j.axis);
  Vector3d to_tips;
  for (int f : fingers_moved(anatomy, joint)) to_tips += fingertip_in_sphere(anatomy, frame, f, anatomy.q_open);
  const bool reversed = frame.mirrored && j.kind != JointKind::prismatic;
  return (dot(axis, to_tips) < 0) != reversed ? j.lower : j.upper;
}

double closed_end(const Anatomy& anatomy, const SphereFrame& frame, int joint) {
  const Joint& j = anatomy.tree.joints[joint];
  // the side on which the fingertip comes nearer to the sphere's centre
  constexpr double tie = 1e-3;          // radii
  constexpr double equal_range = 1e-6;  // of the range
  if (!fingers_moved(anatomy, joint).empty()) {
    const double below = least_distance(anatomy, frame, joint, j.lower);
    const double above = least_distance(anatomy, frame, joint, j.upper);
    if (std::abs(below - above) >= tie) return below < above ? j.lower : j.upper;
  }

  // on a tie the larger side, and of equal sides the one that a convention names
  const double range_below = anatomy.q_open[joint] - j.lower, range_above = j.upper - anatomy.q_open[joint];
  if (std::abs(range_above - range_below) <= equal_range * (j.upper - j.lower))
    return conventional_end(anatomy, frame, joint);
  return range_above > range_below ? j.upper : j.lower;
}

}  // namespace

std::vector<double> find_closed_pose(const Anatomy& anatomy, const SphereFrame& frame, const HandConfig& config) {
  const std::vector<std::optional<double>> stated =
      resolve_joint_values(anatomy.tree, config.q_closed, config, "q_closed");
  std::vector<double> q_closed(anatomy.tree.joints.size());
  for (int i = 0; i < static_cast<int>(q_closed.size()); ++i)
    if (anatomy.tree.joints[i].mimic_master < 0) q_closed[i] = stated[i] ? *stated[i] : closed_end(anatomy, frame, i);
  apply_mimics(anatomy.tree, q_closed);
  return q_closed;
}

}  // namespace uhas
