// Lateral or encompassing: what each joint mainly does to its fingertip (paper, section 3.4;
// docs/method.md#joint-classes).
#pragma once

#include <span>
#include <vector>

#include "uhas/sphere_frame/sphere_frame.hpp"

namespace uhas {

struct JointClassification {
  JointClass joint_class = JointClass::encompassing;
  double lateral_motion = 0;       ///< fingertip travel r sin(phi) |d theta|, summed over the sweep (m)
  double encompassing_motion = 0;  ///< fingertip travel sqrt(dr^2 + (r d phi)^2), summed over the sweep (m)
  double margin = 0;               ///< |lateral - encompassing| / (lateral + encompassing); 0 when the tip stands still
  bool flexed_probe = false;       ///< the sweep was repeated with the joints further out flexed
};

/// One element a joint of the tree; a mimic follower has its master's.
std::vector<JointClassification> classify_joints(const Anatomy& anatomy, const SphereFrame& frame,
                                                 std::span<const double> q_closed);

}  // namespace uhas
