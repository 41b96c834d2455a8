// Wrapping the hand on the undeformed sphere: q_sphere (design 3.4).
#pragma once

#include <span>

#include "uhas/classification/joint_classes.hpp"

namespace uhas {

/// Wraps the fingers on the unit sphere: each encompassing joint, root to tip, turns from open toward closed until its node
/// lies on the sphere. Lateral joints keep the value they have in `q`; the others are overwritten, mimic followers included.
/// @param q  one value a joint of the tree, in and out
void wrap_on_sphere(const Anatomy& anatomy, const SphereFrame& frame, std::span<const JointClassification> classes,
                    std::span<const double> q_closed, std::span<double> q);

}  // namespace uhas
