// Trajectories read from HDF5: datasets `joint_names` [joints] of text and `q` [frames][joints] of numbers.
//
// Files are read by the HDF5 library as they are: a damaged or crafted one can crash it. See hdf5_in_child.hpp.
#pragma once

#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

/// @param max_bytes  of all values together, unpacked
/// Throws Error: file_unreadable, limit_exceeded, syntax; the reader throws Error(syntax).
std::unique_ptr<TrajectoryReader> open_hdf5_trajectory(const std::string& path, std::uint64_t max_bytes);

}  // namespace uhas
