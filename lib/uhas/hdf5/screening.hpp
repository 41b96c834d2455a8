// Looks over an open HDF5 file before any of it is read: only plain, bounded content passes.
#pragma once

#include <hdf5.h>

#include <string>

#include "uhas/hdf5/bounds.hpp"

namespace uhas {

/// Throws Error: as `check_hdf5_bounds`.
void screen_hdf5_file(hid_t file, const std::string& path, const Hdf5Bounds& bounds = {});

}  // namespace uhas
