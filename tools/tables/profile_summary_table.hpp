// A hand profile told in full, as tables for people.
#pragma once

#include <iosfwd>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

/// What was found: hand, palm, sphere, fingers and joints. Angles in degrees, lengths in millimetres.
/// @param in_full  also the three poses of each joint
void print_profile(std::ostream& out, const HandProfile& profile, bool in_full);

}  // namespace uhas::tools
