// The model that a profile was built from, for the tools that need its meshes. A profile holds neither meshes nor where
// they are, only the SHA-256 of every file it was built from: that is how its model is known.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command_line/tool.hpp"
#include "uhas/geometry/hand_geometry.hpp"
#include "uhas/model/hand_model.hpp"

namespace uhas::tools {

/// A profile and the file that it was read from.
struct ProfileFile {
  std::string path;
  HandProfile profile;
};

struct ModelInput {
  std::vector<std::string> urdfs;  ///< in any order
  ModelLoadOptions load;           ///< but for the geometry, which is the profile's
};

/// A model and the URDF that it was read from.
struct ModelFile {
  std::string path;
  HandModel model;
};

/// --urdf FILE, repeatable, and those of `add_load_options`.
void add_model_options(CLI::App& app, ModelInput& input);

/// The URDF as the build of `profile` read it: with the same choice of geometry.
HandModel load_model_of(const HandProfile& profile, const std::string& profile_path, const std::string& urdf,
                        ModelLoadOptions load);

/// The model of each profile: of --urdf the file with the profile's SHA-256, else a file of the same name with that
/// SHA-256 beside the profile or in the current folder, else none. Throws Error: invalid_model for a URDF of --urdf
/// that no profile was built from, or when meshes have changed; write_failed when a file of the model is written as well;
/// what load_hand_model throws.
std::vector<std::optional<ModelFile>> find_models(Tool& tool, std::span<const ProfileFile> profiles,
                                                  const ModelInput& input);

/// The meshes of these models; empty ones where there is none, and a warning that says what is lost, for example "the
/// picture lacks the meshes". Throws as `find_models` and `hand_geometry`.
std::vector<HandGeometry> find_geometries(Tool& tool, std::span<const ProfileFile> profiles, const ModelInput& input,
                                          const std::string& loss);

}  // namespace uhas::tools
