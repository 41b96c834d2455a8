#include "input/model_input.hpp"

#include <algorithm>
#include <filesystem>

#include "input/hand_input.hpp"
#include "input/profile_check.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/files/sha256.hpp"
#include "uhas/profile_builder/settings_json.hpp"

namespace uhas::tools {
namespace {

std::string sha256_of_urdf(const std::string& path, const ModelLoadOptions& load) {
  return sha256_hex(read_urdf_file(path, load));
}

/// The SHA-256 of the URDF; empty for a profile that was not built from files.
std::string stated_sha256(const HandProfile& profile) {
  return profile.sources.empty() ? std::string() : profile.sources.front().sha256;
}

/// A file beside the profile or in the current folder that is its URDF; empty when there is none.
std::string urdf_nearby(const ProfileFile& file, const ModelLoadOptions& load) {
  if (file.profile.sources.empty()) return {};
  const std::filesystem::path name = std::filesystem::path(file.profile.sources.front().name).filename();
  for (const std::filesystem::path& folder :
       {std::filesystem::path(file.path).parent_path(), std::filesystem::path()}) {
    const std::string path = (folder / name).string();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored) && sha256_of_urdf(path, load) == stated_sha256(file.profile))
      return path;
  }
  return {};
}

ModelFile load_unchanged(const ProfileFile& file, const std::string& urdf, const ModelInput& input) {
  ModelFile result{urdf, load_model_of(file.profile, file.path, urdf, input.load)};
  const std::vector<Check> checks = check_sources(file.profile, result.model);
  const auto failed = std::ranges::find(checks, false, &Check::passed);
  if (failed != checks.end())
    throw Error(ErrorCode::invalid_model, urdf,
                failed->item + ": " + failed->detail + " since " + file.path + " was built",
                "rebuild the profile, or see uhas-inspect --check");
  return result;
}

}  // namespace

void add_model_options(CLI::App& app, ModelInput& input) {
  app.add_option("--urdf", input.urdfs,
                 "URDF that the profile was built from, for its meshes; repeatable [the one beside the profile or in "
                 "this folder]")
      ->allow_extra_args(false)
      ->option_text("hand.urdf");
  add_load_options(app, input.load);
}

HandModel load_model_of(const HandProfile& profile, const std::string& profile_path, const std::string& urdf,
                        ModelLoadOptions load) {
  load.geometry = settings_from_json(profile.settings_json, profile_path).load.geometry;
  return load_hand_model(urdf, load);
}

std::vector<std::optional<ModelFile>> find_models(Tool& tool, std::span<const ProfileFile> profiles,
                                                  const ModelInput& input) {
  std::vector<std::string> sha256;
  for (const std::string& urdf : input.urdfs) {
    sha256.push_back(sha256_of_urdf(urdf, input.load));
    if (std::ranges::none_of(profiles,
                             [&](const ProfileFile& file) { return stated_sha256(file.profile) == sha256.back(); }))
      throw Error(ErrorCode::invalid_model, urdf,
                  profiles.size() == 1 ? "is not what " + profiles.front().path + " was built from"
                                       : "none of the profiles was built from it",
                  "name the same URDF, or see uhas-inspect --check for what has changed");
  }

  std::vector<std::optional<ModelFile>> models;
  for (const ProfileFile& file : profiles) {
    const auto named = std::ranges::find(sha256, stated_sha256(file.profile));
    const std::string urdf = named == sha256.end() ? urdf_nearby(file, input.load)
                                                   : input.urdfs[static_cast<std::size_t>(named - sha256.begin())];
    models.push_back(urdf.empty() ? std::nullopt : std::optional(load_unchanged(file, urdf, input)));
    if (models.back()) read_model_files(tool, models.back()->model);
  }
  return models;
}

std::vector<HandGeometry> find_geometries(Tool& tool, std::span<const ProfileFile> profiles, const ModelInput& input,
                                          const std::string& loss) {
  const std::vector<std::optional<ModelFile>> models = find_models(tool, profiles, input);
  std::vector<HandGeometry> geometries;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    geometries.push_back(models[i] ? hand_geometry(profiles[i].profile, models[i]->model, models[i]->path)
                                   : HandGeometry{});
    if (!models[i])
      tool.warn({{profiles[i].path + ": its model is not here, so " + loss + "; name the URDF with --urdf"}});
  }
  return geometries;
}

}  // namespace uhas::tools
