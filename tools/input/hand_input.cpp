#include "input/hand_input.hpp"

#include "command_line/progress.hpp"

namespace uhas::tools {

void add_hand_options(CLI::App& app, HandInput& input) {
  app.add_option("hand.urdf", input.urdf, "URDF of the hand")->required()->type_name("FILE");
  app.add_option("--config", input.config_file, "Hand config (JSON) that overrides what would be inferred")
      ->type_name("FILE");
  add_load_options(app, input.settings.load);
  add_choice<GeometrySource>(
      app, "--geometry", input.settings.load.geometry,
      {{"visual", GeometrySource::visual}, {"collision", GeometrySource::collision}, {"both", GeometrySource::both}},
      "Which meshes are the hand's surface [visual]");
  app.add_option("--radius-scale", input.settings.sphere_frame.radius_scale, "Factor on the sphere's radius [1]")
      ->check(CLI::Range(0.1, 10.0).description(""))
      ->type_name("S");
  app.add_flag("--merge-pinky", input.settings.sphere_frame.merge_pinky,
               "Five fingers: pinky and ring share the mean of their two slots");
}

void add_load_options(CLI::App& app, ModelLoadOptions& load) {
  const auto assign = [&packages = load.packages](const std::vector<std::string>& pairs) {
    for (const std::string& pair : pairs) {
      const std::size_t equals = pair.find('=');
      if (equals == 0 || equals == std::string::npos || equals + 1 == pair.size())
        throw Tool::wrong_usage("--package", pair + " is not NAME=DIR");
      packages.push_back({pair.substr(0, equals), pair.substr(equals + 1)});
    }
  };
  app.add_option_function<std::vector<std::string>>("--package", assign,
                                                    "Folder that package://NAME/ stands for; repeatable")
      ->allow_extra_args(false)
      ->option_text("NAME=DIR");
  app.add_flag("--allow-outside", load.allow_outside,
               "Read meshes outside the folder of the model and of its packages, too");
}

void add_lateral_options(CLI::App& app, LateralTableOptions& options) {
  app.add_option("--lateral-steps", options.steps, "Samples in the sweep of a lateral joint [201]")
      ->check(CLI::Range(11, 100'000).description(""))
      ->type_name("N");
}

void add_surface_options(CLI::App& app, CorrespondenceOptions& options) {
  app.add_option("--samples", options.samples, "Rays cast from the sphere's centre [20000]")
      ->check(CLI::Range(1, 1'000'000).description(""))
      ->type_name("N");
  app.add_option("--points-per-link", options.points_per_link, "Points of a link that the solver uses, at most [32]")
      ->check(CLI::Range(1, 10'000).description(""))
      ->type_name("N");
}

void read_model_files(Tool& tool, const HandModel& model) {
  for (const std::string& path : model.source_paths) tool.files().read(path);
}

BuildStages run_stages(Tool& tool, HandInput& input, BuildStage last) {
  tool.limits().apply_to(input.settings.load);
  if (!input.config_file.empty())
    input.settings.config = read_hand_config(input.config_file, tool.limits().config_bytes);
  BuildStages stages;
  {
    Progress progress(tool, static_cast<int>(last) + 1);
    stages = run_stages(input.urdf, input.settings, last, [&](const char* stage) { progress.begin(stage); });
  }
  read_model_files(tool, stages.model);
  tool.warn(stage_warnings(stages));
  return stages;
}

}  // namespace uhas::tools
