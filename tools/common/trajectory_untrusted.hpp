// HDF5 trajectories from strangers, which may bring the HDF5 library down.
#pragma once

#include "common/trajectory.hpp"

namespace uhas::tools {

/// As `open_hdf5_trajectory`, but the file is read in a child process under the default ChildLimits, which hands over the
/// plain values: the trajectory is in memory as a whole then. Throws what `open_trajectory` throws and Error: syntax when
/// the child was brought down, limit_exceeded when it took too long or too much memory.
std::unique_ptr<TrajectoryReader> open_untrusted_hdf5_trajectory(const std::string& path, std::uint64_t max_bytes);

}  // namespace uhas::tools
