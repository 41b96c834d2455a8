// A hand profile told in full: as JSON (schemas/profile-summary.schema.json) and as tables for people.
#pragma once

#include <iosfwd>

#include "uhas/json/json_text.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

Json profile_summary_json(const HandProfile& profile);

/// What was found: hand, palm, sphere, fingers and joints. Angles in degrees, lengths in millimetres.
/// @param in_full  also the three poses of each joint
void print_profile(std::ostream& out, const HandProfile& profile, bool in_full);

/// Surface points on the links that the finger's joints carry.
int points_of_finger(const HandProfile& profile, const ProfileFinger& finger);

}  // namespace uhas::tools
