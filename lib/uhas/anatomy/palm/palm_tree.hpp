// The model seen from its palm: a tree of the fingers' joints alone, rooted in the palm link's frame P.
#pragma once

#include "uhas/anatomy/anatomy.hpp"
#include "uhas/anatomy/fingers/finger_chains.hpp"

namespace uhas {

/// Fills `hand`, the two links' names, `T_root_palm`, `tree`, `other_joints`, `links`, `model_links`, and the joints of
/// each finger. Joints left out stand at zero, clipped to their limits. A continuous joint gets the limits -+pi; then
/// the limits that the config states are set.
Anatomy make_palm_tree(const HandModel& model, const FingerChains& found, const HandConfig& config);

}  // namespace uhas
