// q_closed: the end of each joint's range toward which the finger closes (docs/method.md#closed-pose).
#pragma once

#include <vector>

#include "uhas/sphere_frame/sphere_frame.hpp"

namespace uhas {

/// One value a joint of the tree: the end of the range on whose side, swept from the open pose with the joints further
/// out open, the fingertip comes nearest to the sphere's centre; the larger side on a tie; of equal sides the one that
/// a positive turn about the fingertip's direction leads to. `config` overrides joint by joint.
std::vector<double> find_closed_pose(const Anatomy& anatomy, const SphereFrame& frame, const HandConfig& config = {});

}  // namespace uhas
