#include "output/report_page.hpp"

#include "json/profile_summary_json.hpp"
#include "text/words.hpp"

namespace uhas::tools {

void add_html_option(Tool& tool, std::string& file, const std::string& description) {
  tool.add_output("--html", file, FileKind::html, description)->type_name("hand.html")->each([](const std::string&) {
    require_html_report();
  });
}

std::vector<ReportHand> report_hands(std::span<const ProfileFile> profiles,
                                     const std::vector<HandGeometry>& geometries) {
  std::vector<ReportHand> hands;
  for (std::size_t i = 0; i < profiles.size(); ++i)
    hands.push_back({.profile = profiles[i].profile,
                     .geometry = geometries[i],
                     .summary_json = profile_summary_json(profiles[i].profile).dump(),
                     .evaluation_json = "",
                     .timeline = std::nullopt});
  return hands;
}

std::string report_page(const std::vector<ReportHand>& hands) {
  std::vector<std::string> names;
  for (const ReportHand& hand : hands) names.push_back(hand.profile.hand);
  return html_report(join(names, ", "), hands);
}

}  // namespace uhas::tools
