#include "uhas/kinematics/mimics.hpp"

#include <algorithm>

namespace uhas {
namespace {

double followed(const Joint& follower, double q_master) {
  return follower.mimic_multiplier * q_master + follower.mimic_offset;
}

}  // namespace

std::vector<int> independent_joints(const KinematicTree& tree, std::span<const int> joints) {
  std::vector<int> independent;
  for (int joint : joints) {
    const int decides = independent_joint(tree, joint);
    if (std::find(independent.begin(), independent.end(), decides) == independent.end()) independent.push_back(decides);
  }
  return independent;
}

void apply_mimics(const KinematicTree& tree, std::span<double> q) {
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    const Joint& joint = tree.joints[i];
    if (joint.mimic_master >= 0) q[i] = followed(joint, q[joint.mimic_master]);
  }
}

void set_with_followers(const KinematicTree& tree, int joint, double value, std::span<double> q) {
  q[joint] = value;
  for (std::size_t i = 0; i < tree.joints.size(); ++i)
    if (tree.joints[i].mimic_master == joint) q[i] = followed(tree.joints[i], value);
}

}  // namespace uhas
