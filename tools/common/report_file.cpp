#include "common/report_file.hpp"

#include "common/output.hpp"
#include "common/profile_summary.hpp"
#include "common/table.hpp"

namespace uhas::tools {

CLI::Option* add_html_option(CLI::App& app, std::string& path, const std::string& description) {
  return app.add_option("--html", path, description)->type_name("FILE");
}

std::vector<ReportHand> report_hands(const Tool& tool, std::span<const ProfileFile> files, const ModelInput& input) {
  const std::vector<std::optional<ModelFile>> models = find_models(files, input);
  std::vector<ReportHand> hands;
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const HandProfile& profile = files[i].profile;
    HandGeometry geometry;
    if (models[i])
      geometry = hand_geometry(profile, models[i]->model, models[i]->path);
    else
      warnings.push_back(files[i].path +
                         ": its URDF is not beside it, so the page draws points and joints alone; name it with --urdf");
    hands.push_back({.profile = profile,
                     .geometry = std::move(geometry),
                     .summary_json = profile_summary_json(profile).dump(),
                     .evaluation_json = "",
                     .timeline = std::nullopt});
  }
  tool.warn(warnings);
  return hands;
}

void write_report(const std::string& path, const std::vector<ReportHand>& hands) {
  std::vector<std::string> names;
  for (const ReportHand& hand : hands) names.push_back(hand.profile.hand);
  write_result(path, html_report(join(names, ", "), hands));
}

}  // namespace uhas::tools
