// Trajectories as HDF5: datasets `joint_names` [joints] of text and `q` [frames][joints] of numbers. Written ones have
// root attributes `format`, `version` and `hand` too, and datasets `residual_max` and `residual_rms` [frames].
//
// Files are read by the HDF5 library as they are: a damaged or crafted one can crash it. See trajectory_in_child.hpp.
#pragma once

#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

std::unique_ptr<TrajectoryReader> open_hdf5_trajectory(const std::string& path, std::uint64_t max_bytes);
std::unique_ptr<TrajectoryWriter> create_hdf5_trajectory(const std::string& path, const TrajectoryHeader& header);

}  // namespace uhas
