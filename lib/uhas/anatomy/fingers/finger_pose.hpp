// A finger in a pose: where its joints and its tip are. All vectors are in P.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "uhas/anatomy/anatomy.hpp"

namespace uhas {

/// Independent joint that decides the value of `joint`: its mimic master, or itself.
int variable_of(const KinematicTree& tree, int joint);

/// Sets an independent joint and lets its followers follow.
void set_joint(const KinematicTree& tree, int variable, double value, std::span<double> q);

/// The middle of a joint's range.
double mid_range(const Joint& joint);

/// Every independent joint at the middle of its range.
std::vector<double> mid_pose(const KinematicTree& tree);

/// The value of `joint` that a designer would call neutral among those that do well: zero when its
/// `objective` is within `tolerance` of the best of the range; on a flat objective the middle of the range, unless zero
/// lies near it; else the best value.
/// @param zero_is_neutral  false on a hand whose zeros say nothing: then zero is a value like others
double preferred_value(const Joint& joint, double tolerance, bool zero_is_neutral,
                       const std::function<double(double)>& objective);

/// Joints of one finger in a pose.
struct FingerPose {
  std::vector<Vector3d> origin, axis;  ///< one a joint, root to tip
  Vector3d tip;
};
void pose_finger(const Anatomy& anatomy, const FingerAnatomy& finger, std::span<const double> q, FingerPose& pose);

/// Sum of the distances between the joints and to the tip: the finger's length when straight (m).
double finger_length(const Anatomy& anatomy, const FingerAnatomy& finger);

}  // namespace uhas
