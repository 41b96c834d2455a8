// uhas-inspect: what a hand profile says, and whether it still holds.
#include <algorithm>
#include <iostream>

#include "input/profile_check.hpp"
#include "input/profile_input.hpp"
#include "json/json_value.hpp"
#include "json/profile_check_json.hpp"
#include "json/profile_summary_json.hpp"
#include "output/pictures.hpp"
#include "tables/findings_table.hpp"
#include "tables/profile_check_table.hpp"
#include "tables/profile_summary_table.hpp"
#include "text/words.hpp"
#include "uhas/profile_io/reseal_profile.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

constexpr std::size_t kFailuresNamed = 3;  // in the error line; the table has them all

struct Options {
  std::vector<std::string> profiles;
  std::string checked_urdf;
  std::string value;  // key of the summary
  ModelInput model;
  PictureFiles pictures;
  bool findings = false, validate = false, reseal = false;
};

void add_options(Tool& tool, Options& options) {
  CLI::App& app = tool.options();
  app.description("Shows what a hand profile says: palm, sphere, fingers, joints and poses.");
  app.add_option("profile.h5", options.profiles, "Hand profile; several with --html")
      ->required()
      ->option_text("FILE... REQUIRED");
  app.add_option("-g,--get", options.value,
                 "Print one value of the JSON summary instead, for example sphere.radius or fingers.0.name")
      ->type_name("KEY");
  app.add_flag("--findings", options.findings, "Show also what was inferred of the hand, how surely and why");
  app.add_flag("--validate", options.validate, "Check instead that the profile is sound; exit 1 when it is not");
  app.add_option("--check", options.checked_urdf,
                 "Check instead that the profile was built from this URDF and its meshes; exit 1 when not")
      ->type_name("hand.urdf");
  add_picture_options(tool, options.pictures);
  add_model_options(app, options.model);
  app.add_flag("--reseal", options.reseal, "Make a profile that was edited with an HDF5 tool readable again");
}

ExitCode report(const Tool& tool, const std::string& path, const HandProfile& profile,
                const std::vector<Check>& checks) {
  const bool passed = std::ranges::all_of(checks, &Check::passed);
  if (tool.json()) {
    std::cout << to_text(profile_check_json(profile, checks));
  } else {
    print_checks(std::cout, checks);
  }
  if (passed) return ExitCode::done;

  std::vector<std::string> failed;
  for (const Check& check : checks)
    if (!check.passed) failed.push_back(check.item + " (" + check.detail + ")");
  if (failed.size() > kFailuresNamed) {
    const std::string rest = "and " + std::to_string(failed.size() - kFailuresNamed) + " more";
    failed.resize(kFailuresNamed);
    failed.push_back(rest);
  }
  tool.report_error(path + ": check failed: " + join(failed, ", ") + "; rebuild it with uhas-build-profile");
  return ExitCode::run_failed;
}

/// What the options cannot do together.
void check_usage(const Options& options) {
  const PictureFiles& pictures = options.pictures;
  if (options.profiles.size() > 1) {
    const bool asks_for_one = options.validate || !options.checked_urdf.empty() || !pictures.glb.empty() ||
                              !pictures.ply.empty() || !pictures.svg.empty();
    if (pictures.html.empty() || asks_for_one)
      throw Tool::wrong_usage("profile.h5", "several profiles are for --html alone");
  }
  if (!options.model.urdfs.empty() && pictures.html.empty() && pictures.glb.empty())
    throw Tool::wrong_usage("--urdf", "needs --html or --gltf");
}

ExitCode run(Tool& tool) {
  Options options;
  add_options(tool, options);
  tool.parse();
  tool.limits().apply_to(options.model.load);
  check_usage(options);

  std::vector<ProfileFile> files;
  for (const std::string& path : options.profiles) {
    if (options.reseal) {
      tool.files().rewrite(path);
      reseal_profile(path);
      tool.log("resealed " + path);
    }
    files.push_back({path, read_profile(tool, path)});
  }
  const auto& [path, profile] = files.front();
  if (options.validate || !options.checked_urdf.empty()) {
    std::vector<Check> checks;
    if (options.validate) checks = check_behaviour(profile);
    if (!options.checked_urdf.empty())
      std::ranges::copy(check_sources(profile, load_model_of(profile, path, options.checked_urdf, options.model.load)),
                        std::back_inserter(checks));
    return report(tool, path, profile, checks);
  }

  if (options.pictures.any()) {
    write_pictures(tool, options.pictures, files, options.model);
    return ExitCode::done;
  }
  if (!options.value.empty()) {
    std::cout << to_plain_line(value_at(profile_summary_json(profile), options.value));
    return ExitCode::done;
  }
  if (tool.json()) {
    std::cout << to_text(profile_summary_json(profile));
  } else {
    print_profile(std::cout, profile, true);
    if (options.findings) {
      std::cout << '\n';
      print_findings(std::cout, profile.findings);
    }
  }
  tool.warn(profile.warnings);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-inspect", argc, argv, run); }
