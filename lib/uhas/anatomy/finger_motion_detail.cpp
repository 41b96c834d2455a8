#include "uhas/anatomy/finger_motion_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "uhas/runtime/forward_kinematics.hpp"

namespace uhas {
namespace {

/// A joint turns the tip when the tip is this part of the finger's length off its axis.
constexpr double kShortestArm = 0.1;
/// Flexion axes are parallel within 30 degrees: side joints between them stand at mid range, which need not be neutral.
constexpr double kParallel = 0.866;
/// A straight phalanx at zero may be this part shorter than the longest reach: fingertips are offset from the joint's line.
constexpr double kStraightTolerance = 0.015;
/// Fingers bend back at most this far (rad); a zero so near to the open end is where the designer put "straight".
constexpr double kHyperextension = 0.4;
/// Where "straight" lies from the open end on when zero does not tell (rad).
constexpr double kTypicalHyperextension = 0.15;

/// Signed rate of flexion joint `position` per unit of its variable, seen along the last flexion axis.
double flexion_rate(const Anatomy& anatomy, const FingerAnatomy& finger, const FingerPose& pose, int position, int last) {
  const Joint& joint = anatomy.tree.joints[finger.joints[position]];
  const double sense = dot(pose.axis[position], pose.axis[last]) < 0 ? -1.0 : 1.0;
  return sense * (joint.mimic_master >= 0 ? joint.mimic_multiplier : 1.0);
}

std::vector<double> mid_pose(const KinematicTree& tree) {
  std::vector<double> q;
  for (const Joint& joint : tree.joints) q.push_back(mid_range(joint));
  apply_mimics(tree, q);
  return q;
}

/// Straightens the flexion joints beyond the first: from the last inward, each puts the tip farthest from the flexion joint
/// before it. Returns which variables were set.
std::vector<int> straighten(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                            std::span<double> q) {
  std::vector<int> set;
  FingerPose pose;
  for (std::size_t i = flexion.positions.size(); i-- > 1;) {
    const int variable = variable_of(anatomy.tree, finger.joints[flexion.positions[i]]);
    if (std::find(set.begin(), set.end(), variable) != set.end()) continue;
    const auto reach = [&](double value) {
      set_joint(anatomy.tree, variable, value, q);
      pose_finger(anatomy, finger, q, pose);
      return norm(pose.tip - pose.origin[flexion.positions[i - 1]]);
    };
    const double tolerance = kStraightTolerance * finger_length(anatomy, finger);
    set_joint(anatomy.tree, variable, preferred_value(anatomy.tree.joints[variable], tolerance, reach), q);
    set.push_back(variable);
  }
  return set;
}

Flexion find_sliding(const FingerPose& pose, int last, Vector3d palm_center) {
  Flexion flexion;
  flexion.positions = {last};
  flexion.sliding = true;
  const Vector3d inward = palm_center - pose.tip;
  const double toward = dot(inward, pose.axis[last]);
  flexion.closing_sign = toward < 0 ? -1 : 1;
  flexion.evidence = norm(inward) > 0 ? std::min(1.0, 2 * std::abs(toward) / norm(inward)) : 0;
  return flexion;
}

}  // namespace

int variable_of(const KinematicTree& tree, int joint) {
  const int master = tree.joints[joint].mimic_master;
  return master < 0 ? joint : master;
}

void set_joint(const KinematicTree& tree, int variable, double value, std::span<double> q) {
  q[variable] = value;
  apply_mimics(tree, q);
}

double mid_range(const Joint& joint) { return (joint.lower + joint.upper) / 2; }

double preferred_value(const Joint& joint, double tolerance, const std::function<double(double)>& objective) {
  constexpr int samples = 24;
  constexpr double near_middle = 0.3;  // of half the range
  const double step = (joint.upper - joint.lower) / samples;
  int best = 0;
  std::array<double, samples + 1> value;
  for (int i = 0; i <= samples; ++i) {
    value[i] = objective(joint.lower + i * step);
    if (value[i] > value[best]) best = i;
  }
  // Golden-section search between the neighbours of the best sample.
  double a = joint.lower + std::max(best - 1, 0) * step, b = joint.lower + std::min(best + 1, samples) * step;
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
  if (value[best] >= maximum) optimum = joint.lower + best * step, maximum = value[best];

  const double zero = clamp_to_limits(joint, 0.0), middle = mid_range(joint);
  const bool flat = maximum - *std::min_element(value.begin(), value.end()) <= tolerance;
  const bool zero_in_middle = std::abs(zero - middle) <= near_middle * (joint.upper - joint.lower) / 2;
  if (flat) return zero_in_middle ? zero : middle;
  return objective(zero) >= maximum - tolerance ? zero : optimum;
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

Flexion find_flexion(const Anatomy& anatomy, const FingerAnatomy& finger, Vector3d palm_center) {
  const std::vector<Joint>& joints = anatomy.tree.joints;
  std::vector<double> q = mid_pose(anatomy.tree);
  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  const double length = finger_length(anatomy, finger);

  // the last joint that moves the tip, and those parallel to it
  int last = static_cast<int>(finger.joints.size()) - 1;
  const auto moves_tip = [&](int position) {
    return joints[finger.joints[position]].kind == JointKind::prismatic ||
           norm(cross(pose.axis[position], pose.tip - pose.origin[position])) >= kShortestArm * length;
  };
  while (last > 0 && !moves_tip(last)) --last;
  if (joints[finger.joints[last]].kind == JointKind::prismatic) return find_sliding(pose, last, palm_center);
  Flexion flexion;
  for (int i = 0; i <= last; ++i) {
    const bool turns = joints[finger.joints[i]].kind != JointKind::prismatic;
    if (turns && std::abs(dot(pose.axis[i], pose.axis[last])) > kParallel) flexion.positions.push_back(i);
  }

  // the range to both sides of the extended pose
  const int first = flexion.positions.front();
  std::vector<int> variables = straighten(anatomy, finger, flexion, q);
  pose_finger(anatomy, finger, q, pose);
  const Vector3d outward = orthogonal_part(pose.origin[first] - palm_center, pose.axis[last]);
  const int first_variable = variable_of(anatomy.tree, finger.joints[first]);
  const bool first_is_free = std::find(variables.begin(), variables.end(), first_variable) == variables.end();
  if (first_is_free && norm(outward) > kShortestArm * length) {
    set_joint(anatomy.tree, first_variable,
              preferred_value(joints[first_variable], 0,
                              [&](double value) {
                                set_joint(anatomy.tree, first_variable, value, q);
                                pose_finger(anatomy, finger, q, pose);
                                return dot(pose.tip - pose.origin[first], outward);
                              }),
              q);
    variables.push_back(first_variable);
  }
  double positive = 0, negative = 0;
  for (int position : flexion.positions) {
    const int variable = variable_of(anatomy.tree, finger.joints[position]);
    if (std::find(variables.begin(), variables.end(), variable) == variables.end()) continue;
    const double rate = flexion_rate(anatomy, finger, pose, position, last);
    const double up = joints[variable].upper - q[variable], down = q[variable] - joints[variable].lower;
    positive += std::abs(rate) * (rate > 0 ? up : down);
    negative += std::abs(rate) * (rate > 0 ? down : up);
  }
  flexion.closing_sign = positive < negative ? -1 : 1;
  if (positive + negative > 0) flexion.evidence = std::abs(positive - negative) / (positive + negative);
  return flexion;
}

void extend_finger(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion, std::span<double> q) {
  const std::vector<Joint>& joints = anatomy.tree.joints;
  const std::vector<int> set = straighten(anatomy, finger, flexion, q);
  const int variable = variable_of(anatomy.tree, finger.joints[flexion.positions.front()]);
  if (std::find(set.begin(), set.end(), variable) != set.end()) return;
  FingerPose pose;
  pose_finger(anatomy, finger, q, pose);
  const double sense = flexion.closing_sign * flexion_rate(anatomy, finger, pose, flexion.positions.front(),
                                                           flexion.positions.back());
  const Joint& joint = joints[variable];
  const double open_end = sense > 0 ? joint.lower : joint.upper;
  double value = open_end;
  if (!flexion.sliding) {
    const double zero = clamp_to_limits(joint, 0.0);
    const double bent_back = std::min(kTypicalHyperextension, (joint.upper - joint.lower) / 4);
    value = std::abs(zero - open_end) <= kHyperextension ? zero : open_end + (sense > 0 ? bent_back : -bent_back);
  }
  set_joint(anatomy.tree, variable, value, q);
}

FingerPosture measure_posture(const Anatomy& anatomy, const FingerAnatomy& finger, const Flexion& flexion,
                              std::span<const double> q, FingerPose& scratch) {
  pose_finger(anatomy, finger, q, scratch);
  FingerPosture posture;
  posture.root = scratch.origin.front();
  posture.tip = scratch.tip;
  const Vector3d along = scratch.tip - scratch.origin[flexion.positions.front()];
  const Vector3d axis = flexion.closing_sign * scratch.axis[flexion.positions.back()];
  posture.direction = normalized(orthogonal_part(along, axis));
  if (flexion.sliding) {
    posture.closing = axis;
    posture.axis = cross(posture.direction, posture.closing);
  } else {
    posture.axis = axis;
    posture.closing = cross(posture.axis, posture.direction);
  }
  return posture;
}

}  // namespace uhas
