// What the checks of a profile found, as a JSON document.
#pragma once

#include <vector>

#include "input/profile_check.hpp"
#include "uhas/json/json_text.hpp"

namespace uhas::tools {

/// {"format": "uhas-profile-check", ...} (schemas/profile-check.schema.json).
Json profile_check_json(const HandProfile& profile, const std::vector<Check>& checks);

}  // namespace uhas::tools
