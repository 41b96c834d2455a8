// HDF5 trajectories read in a process of their own: a damaged or crafted one may bring the HDF5 library down.
#pragma once

#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

/// As `open_hdf5_trajectory`, but a child process reads the file and hands over blocks of plain frames, in constant
/// memory. The reader throws what `open_hdf5_trajectory` and its reader throw, and Error: syntax when the child was
/// brought down, limit_exceeded when it took too long or too much memory.
std::unique_ptr<TrajectoryReader> open_hdf5_trajectory_in_child(const std::string& path, std::uint64_t max_bytes,
                                                                const ChildLimits& limits);

}  // namespace uhas
