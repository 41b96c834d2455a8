// A hand profile told in full, as a JSON document (schemas/profile-summary.schema.json).
#pragma once

#include "uhas/json/json_text.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

Json profile_summary_json(const HandProfile& profile);

/// Surface points on the links that the finger's joints carry.
int points_of_finger(const HandProfile& profile, const ProfileFinger& finger);

}  // namespace uhas::tools
