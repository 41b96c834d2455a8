// From a URDF to a hand profile: the whole preprocessing in one call.
#pragma once

#include <functional>
#include <string>

#include "uhas/anatomy/hand_config.hpp"
#include "uhas/base/export.hpp"
#include "uhas/correspondences/correspondence_options.hpp"
#include "uhas/lateral_tables/lateral_table_options.hpp"
#include "uhas/model/model_load_options.hpp"
#include "uhas/sphere_frame/sphere_frame_options.hpp"

namespace uhas {

struct BuildSettings {
  ModelLoadOptions load;
  HandConfig config;
  SphereFrameOptions sphere_frame;
  LateralTableOptions lateral_tables;
  CorrespondenceOptions correspondences;
};

/// Called when a stage begins, with its name in plain words ("reading meshes").
using BuildListener = std::function<void(const char* stage)>;

/// The profile of the hand in the file `urdf_path`; what is doubtful of it is in `HandProfile::warnings`.
/// Throws Error: file_unreadable, syntax, invalid_model, invalid_mesh, invalid_hand, invalid_config, limit_exceeded.
UHAS_API HandProfile build_profile(const std::string& urdf_path, const BuildSettings& settings = {},
                                   const BuildListener& listener = {});

}  // namespace uhas
