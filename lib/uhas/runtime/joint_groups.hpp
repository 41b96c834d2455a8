// The joints of a hand by what they do to its fingertips, and the posture that rewards refer to
// (docs/method.md#observation).
#pragma once

#include <vector>

#include "uhas/base/export.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Indices into the profile's joints, increasing; a mimic follower stands beside its master. Every joint is in one
/// of the two.
UHAS_API std::vector<int> lateral_joints(const HandProfile& profile);
UHAS_API std::vector<int> encompassing_joints(const HandProfile& profile);

/// q_sphere: the hand wrapped on the undeformed sphere. [joints] rad, m for prismatic joints, mimic followers included.
UHAS_API std::vector<double> reference_posture(const HandProfile& profile);

}  // namespace uhas
