// Writes a hand profile. The format is described in schemas/hand-profile-v1.md.
#pragma once

#include <string>

#include "uhas/base/export.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Validates `profile` and writes it to `path`. The same profile gives the same bytes.
///
/// The file appears whole or not at all: a temporary file in the same folder is written, synced and renamed over
/// `path`. A symbolic link at `path` is followed; anything there but a regular file is refused.
///
/// Throws Error: invalid_profile (see `validate_profile`), limit_exceeded (over 256 MiB), write_failed.
/// Safe to call from several threads; calls take turns.
UHAS_API void write_profile(const HandProfile& profile, const std::string& path);

}  // namespace uhas
