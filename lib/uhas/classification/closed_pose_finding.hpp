// How far the closed pose can be trusted.
#pragma once

#include <span>

#include "uhas/classification/joint_classes.hpp"

namespace uhas {

/// The finding "q_closed". Its confidence is the part of the encompassing joints that a second rule sends to the same
/// side: closing begins toward where the pad faces. It is 1 when `config` states every joint.
HandFinding explain_closed_pose(const Anatomy& anatomy, const SphereFrame& frame,
                                std::span<const JointClassification> classes, std::span<const double> q_closed,
                                const HandConfig& config = {});

}  // namespace uhas
