// Looks over an open HDF5 file before any of it is read: only plain, bounded content passes.
#pragma once

#include <hdf5.h>

#include <string>

namespace uhas::detail {

/// Refuses links that are not hard links, objects that are neither groups nor datasets, types other than integers,
/// floating-point numbers and fixed-length strings, external and virtual storage, filters other than deflate, and more
/// objects, rows or bytes than a hand profile can need. Attributes are held to the same rules.
/// Throws Error: invalid_profile, limit_exceeded.
void screen_hdf5_file(hid_t file, const std::string& path);

}  // namespace uhas::detail
