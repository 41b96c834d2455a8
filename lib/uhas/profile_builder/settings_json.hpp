// The build settings as text, kept in the profile so that the same model and settings rebuild it.
#pragma once

#include <string>

#include "uhas/profile_builder/build_profile.hpp"

namespace uhas {

/// Canonical JSON: sorted keys, no white space, shortest numbers that round-trip. What belongs to one machine or does
/// not change the result (package folders, size bounds) is left out.
std::string to_canonical_json(const BuildSettings& settings);

/// The settings that `to_canonical_json` wrote; everything it leaves out has its default.
/// Throws Error(invalid_profile) naming `file` for text of another form.
BuildSettings settings_from_json(const std::string& text, const std::string& file);

}  // namespace uhas
