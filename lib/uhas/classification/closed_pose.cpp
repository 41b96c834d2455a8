#include "uhas/classification/closed_pose.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/classification/finger_sweep_detail.hpp"
#include "uhas/runtime/forward_kinematics.hpp"

namespace uhas {
namespace {

/// Least distance of the moved fingertips (their mean) from the sphere's centre while `joint` goes from open to `end`, in radii.
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

double closed_end(const Anatomy& anatomy, const SphereFrame& frame, int joint) {
  const Joint& j = anatomy.tree.joints[joint];
  const double larger_side = j.upper - anatomy.q_open[joint] >= anatomy.q_open[joint] - j.lower ? j.upper : j.lower;
  if (fingers_moved(anatomy, joint).empty()) return larger_side;
  constexpr double tie = 1e-3;  // radii
  const double below = least_distance(anatomy, frame, joint, j.lower), above = least_distance(anatomy, frame, joint, j.upper);
  if (std::abs(below - above) < tie) return larger_side;
  return below < above ? j.lower : j.upper;
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
