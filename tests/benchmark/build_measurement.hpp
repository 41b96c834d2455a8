// What a build of a profile costs, and what loading its meshes alone would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measurement.hpp"

namespace uhas::benchmark {

struct StageTime {
  std::string stage;  ///< as build_profile names it
  Summary summary;    ///< ns
};

struct BuildMeasurement {
  std::string hand;
  std::size_t mesh_files = 0, mesh_file_bytes = 0;
  std::size_t mesh_memory = 0;  ///< bytes of all vertices and triangles of the hand model
  Summary assimp;               ///< ns: the same mesh files through one Assimp::Importer, from the page cache
  Summary build;                ///< ns: URDF to the bytes of the profile's file, not written
  std::vector<StageTime> stages;
  std::size_t peak_memory = 0;  ///< bytes: largest resident set of a process that did nothing but this build
};

/// Each of the hands, `rounds` times in turn. Call it first in a process: the peak memory is that of children it forks.
std::vector<BuildMeasurement> measure_builds(const std::vector<std::filesystem::path>& urdfs, int rounds);

}  // namespace uhas::benchmark
