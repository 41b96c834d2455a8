// Reads a hand profile. The format is described in schemas/hand-profile-v1.md.
#pragma once

#include <string>

#include "uhas/base/errors.hpp"
#include "uhas/base/export.hpp"
#include "uhas/fence/child_limits.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// The hand profile in the file `path`, validated.
///
/// The file is read into memory once; its length and SHA-256 are checked before HDF5 sees a byte of it, and what was
/// checked is what is parsed. That guards against damage, not malice: whoever writes a file can seal it with a right
/// hash, and HDF5 has crashed on crafted files. For a profile of unknown origin there is `read_untrusted_profile`.
///
/// Throws Error: file_unreadable; limit_exceeded (over 256 MiB, in the file or unpacked); unsupported_version (another
/// major version); invalid_profile (damaged, alien, inconsistent), which names the dataset where there is one. Safe to
/// call from several threads; calls take turns.
UHAS_API HandProfile read_profile(const std::string& path);

/// The same for a profile from a stranger: the file is read in a child process under `limits`, which hands over the
/// validated profile, flat, so that HDF5 sees no byte of the stranger's in this process.
/// Throws what `read_profile` throws: invalid_profile also when the child was brought down, limit_exceeded when it took
/// too long or too much memory. Call it while no other thread reads or writes a profile.
UHAS_API HandProfile read_untrusted_profile(const std::string& path, const ChildLimits& limits = {});

}  // namespace uhas
