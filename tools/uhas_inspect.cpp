// uhas-inspect: what a hand profile says, and whether it still holds.
#include <algorithm>
#include <iostream>

#include "common/findings.hpp"
#include "common/hand_input.hpp"
#include "common/json_value.hpp"
#include "common/model_input.hpp"
#include "common/profile_check.hpp"
#include "common/profile_input.hpp"
#include "common/profile_summary.hpp"
#include "common/table.hpp"
#include "uhas/base/file_bytes.hpp"
#include "uhas/profile_io/reseal_profile.hpp"
#include "uhas/report/correspondences_ply.hpp"
#include "uhas/report/hand_glb.hpp"
#include "uhas/report/lateral_tables_svg.hpp"
#include "uhas/runtime/joint_groups.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

constexpr std::size_t kFailuresNamed = 3;  // in the error line; the table has them all

struct Options {
  std::string profile, urdf;
  std::string value;  // key of the summary
  ModelInput model;
  std::string glb, ply, svg;
  bool findings = false, validate = false, reseal = false;
};

void add_options(CLI::App& app, Options& options) {
  app.description("Shows what a hand profile says: palm, sphere, fingers, joints and poses.");
  app.add_option("profile.h5", options.profile, "Hand profile")->required()->type_name("FILE");
  app.add_option("-g,--get", options.value,
                 "Print one value of the JSON summary instead, for example sphere.radius or fingers.0.name")
      ->type_name("KEY");
  app.add_flag("--findings", options.findings, "Show also what was inferred of the hand, how surely and why");
  app.add_flag("--validate", options.validate, "Check instead that the profile is sound; exit 1 when it is not");
  app.add_option("--check", options.urdf,
                 "Check instead that the profile was built from this URDF and its meshes; exit 1 when not")
      ->type_name("hand.urdf");
  app.add_option("--gltf", options.glb, "Draw the wrapped hand, its sphere and its surface points as binary glTF")->type_name("hand.glb");
  app.add_option("--ply", options.ply, "Write the surface points with their sphere coordinates as PLY")->type_name("points.ply");
  app.add_option("--svg", options.svg, "Draw the lateral tables as SVG")->type_name("tables.svg");
  add_model_options(app, options.model);
  app.add_flag("--reseal", options.reseal, "Make a profile that was edited with an HDF5 tool readable again");
}

ExitCode report(const Tool& tool, const Options& options, const HandProfile& profile,
                const std::vector<Check>& checks) {
  const bool passed = std::ranges::all_of(checks, &Check::passed);
  if (tool.json()) {
    std::cout << to_text(profile_check_json(profile, checks));
  } else {
    Table table({{"check"}, {"result"}, {"found"}});
    for (const Check& check : checks)
      table.add_row({check.item, check.passed ? "ok" : Table::Cell("FAILED", Tone::error), check.detail});
    table.print(std::cout);
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
  tool.report_error(options.profile + ": check failed: " + join(failed, ", ") + "; rebuild it with uhas-build-profile");
  return ExitCode::run_failed;
}

/// The meshes of the profile's model; without a model empty ones and a warning.
HandGeometry find_geometry(const Tool& tool, const ProfileFile& file, const ModelInput& input) {
  const std::optional<ModelFile> model = find_models({&file, 1}, input).front();
  if (model) return hand_geometry(file.profile, model->model, model->path);
  tool.warn({{file.path + ": its model is not here, so the picture lacks the meshes; name the URDF with --urdf"}});
  return {};
}

/// Writes the pictures that were asked for; false when none was.
bool draw(const Tool& tool, const Options& options, const HandProfile& profile) {
  const auto write = [&](const std::string& path, const auto& content) {
    replace_file(path, std::as_bytes(std::span(content)));
    if (!tool.quiet()) std::cout << "Wrote " << path << '\n';
  };
  if (!options.glb.empty())
    write(options.glb, hand_glb(profile, find_geometry(tool, {options.profile, profile}, options.model), reference_posture(profile)));
  if (!options.ply.empty()) write(options.ply, correspondences_ply(profile));
  if (!options.svg.empty()) write(options.svg, lateral_tables_svg(profile));
  return !(options.glb.empty() && options.ply.empty() && options.svg.empty());
}

ExitCode run(Tool& tool) {
  Options options;
  add_options(tool.options(), options);
  tool.parse();
  options.model.load.untrusted = tool.untrusted();

  if (options.reseal) {
    reseal_profile(options.profile);
    tool.log("resealed " + options.profile);
  }
  const HandProfile profile = read_profile(tool, options.profile);
  if (options.validate || !options.urdf.empty()) {
    std::vector<Check> checks;
    if (options.validate) checks = check_behaviour(profile);
    if (!options.urdf.empty())
      std::ranges::copy(check_sources(profile, load_model_of(profile, options.profile, options.urdf, options.model.load)),
                        std::back_inserter(checks));
    return report(tool, options, profile, checks);
  }

  if (draw(tool, options, profile)) return ExitCode::done;
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
