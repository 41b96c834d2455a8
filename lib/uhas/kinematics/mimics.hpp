// Joints that mimic others: an independent joint and its followers are one unknown.
#pragma once

#include <span>
#include <vector>

#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// The joint that decides where `joint` stands: itself, or the master that it mimics.
inline int independent_joint(const KinematicTree& tree, int joint) {
  const int master = tree.joints[joint].mimic_master;
  return master < 0 ? joint : master;
}

/// The independent joints behind `joints`, each once, in the order in which they come first.
std::vector<int> independent_joints(const KinematicTree& tree, std::span<const int> joints);

/// Whether `other` is `joint` or follows it.
inline bool turns_with(const KinematicTree& tree, int other, int joint) {
  return other == joint || tree.joints[other].mimic_master == joint;
}

/// Overwrites every mimic follower in `q` by multiplier * q[master] + offset. `q`: one value a joint of `tree`.
void apply_mimics(const KinematicTree& tree, std::span<double> q);

/// The same for one unknown: `q` with the independent joint `joint` at `value` and its followers where that puts them.
void set_with_followers(const KinematicTree& tree, int joint, double value, std::span<double> q);

}  // namespace uhas
