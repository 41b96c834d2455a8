// Makes a profile that was edited with an HDF5 tool readable again.
#pragma once

#include <string>

namespace uhas {

/// Rewrites the user block of `path` (length and SHA-256) after an edit, if the edited content is a valid hand profile;
/// otherwise the file stays as it is. Atomic, as `write_profile`.
///
/// This trusts the file: HDF5 opens content that no hash vouches for.
/// Throws Error: as `read_profile` and `write_profile`.
void reseal_profile(const std::string& path);

}  // namespace uhas
