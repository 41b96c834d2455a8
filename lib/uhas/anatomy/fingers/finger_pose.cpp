#include "uhas/anatomy/fingers/finger_pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {

int variable_of(const KinematicTree& tree, int joint) {
  const int master = tree.joints[joint].mimic_master;
  return master < 0 ? joint : master;
}

void set_joint(const KinematicTree& tree, int variable, double value, std::span<double> q) {
  q[variable] = value;
  apply_mimics(tree, q);
}

double mid_range(const Joint& joint) { return (joint.lower + joint.upper) / 2; }

std::vector<double> mid_pose(const KinematicTree& tree) {
  std::vector<double> q;
  for (const Joint& joint : tree.joints) q.push_back(mid_range(joint));
  apply_mimics(tree, q);
  return q;
}

double preferred_value(const Joint& joint, double tolerance, bool zero_is_neutral,
                       const std::function<double(double)>& objective) {
  constexpr int samples = 24;
  const auto at = [&](int i) {  // the ends exactly, whatever rounding makes of the steps
    return i == samples ? joint.upper : joint.lower + (joint.upper - joint.lower) * i / samples;
  };
  int best = 0;
  std::array<double, samples + 1> value;
  for (int i = 0; i <= samples; ++i) {
    value[i] = objective(at(i));
    if (value[i] > value[best]) best = i;
  }
  // Golden-section search between the neighbours of the best sample.
  double a = at(std::max(best - 1, 0)), b = at(std::min(best + 1, samples));
  constexpr double ratio = 0.6180339887498949;
  double x1 = b - ratio * (b - a), x2 = a + ratio * (b - a), f1 = objective(x1), f2 = objective(x2);
  for (int i = 0; i < 25; ++i) {
    if (f1 > f2) {
      b = x2, x2 = x1, f2 = f1;
      x1 = b - ratio * (b - a), f1 = objective(x1);
    } else {
      a = x1, x1 = x2, f1 = f2;
      x2 = a + ratio * (b - a), f2 = objective(x2);
    }
  }
  double optimum = f1 > f2 ? x1 : x2, maximum = std::max(f1, f2);
  if (value[best] >= maximum) optimum = at(best), maximum = value[best];

  const double middle = mid_range(joint);
  const bool zero_in_range = joint.lower <= 0 && joint.upper >= 0;
  if (zero_is_neutral && zero_in_range && objective(0) >= maximum - tolerance) return 0;
  return objective(middle) >= maximum - tolerance ? middle : clamp_to_limits(joint, optimum);
}

void pose_finger(const Anatomy& anatomy, const FingerAnatomy& finger, std::span<const double> q, FingerPose& pose) {
  pose.origin.clear();
  pose.axis.clear();
  RigidTransformd T_palm_joint;
  for (int index : finger.joints) {
    const Joint& joint = anatomy.tree.joints[index];
    const RigidTransformd T_palm_fixed = T_palm_joint * joint.T_parent_joint;
    pose.origin.push_back(T_palm_fixed.translation);
    pose.axis.push_back(T_palm_fixed.rotation * joint.axis);
    T_palm_joint = T_palm_fixed * joint_motion(joint, q[index]);
  }
  pose.tip = T_palm_joint * (anatomy.links[finger.tip_link].T_joint_link * finger.p_tip_link);
}

double finger_length(const Anatomy& anatomy, const FingerAnatomy& finger) {
  double length = norm(anatomy.links[finger.tip_link].T_joint_link * finger.p_tip_link);
  for (std::size_t i = 1; i < finger.joints.size(); ++i)
    length += norm(anatomy.tree.joints[finger.joints[i]].T_parent_joint.translation);
  return length;
}

}  // namespace uhas
