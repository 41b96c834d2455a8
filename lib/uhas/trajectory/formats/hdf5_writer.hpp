// Trajectories written as HDF5: what hdf5_reader.hpp reads, root attributes `format`, `version` and `hand`, and datasets
// `residual_max` and `residual_rms` [frames].
#pragma once

#include "uhas/trajectory/trajectory.hpp"

namespace uhas {

/// Throws Error(write_failed).
std::unique_ptr<TrajectoryWriter> create_hdf5_trajectory(const std::string& path, const TrajectoryHeader& header);

}  // namespace uhas
