// uhas-build-profile: a URDF becomes a hand profile.
#include <algorithm>
#include <iostream>

#include "input/hand_input.hpp"
#include "json/profile_summary_json.hpp"
#include "output/hand_config_output.hpp"
#include "tables/findings_table.hpp"
#include "tables/profile_summary_table.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

std::string default_output(const HandProfile& profile) {
  std::string name = profile.hand.empty() ? "hand" : profile.hand;
  std::ranges::replace(name, '/', '_');
  return name + ".h5";
}

ExitCode build(Tool& tool) {
  HandInput input;
  std::string output, config_output;
  tool.options().description("Builds the profile of a robot hand from its URDF.");
  add_hand_options(tool.options(), input);
  add_lateral_options(tool.options(), input.settings.lateral_tables);
  add_surface_options(tool.options(), input.settings.correspondences);
  tool.add_output("-o,--output", output, FileKind::profile, "Hand profile to write [<robot name>.h5]");
  add_write_config_option(tool, config_output);
  tool.parse();

  const BuildStages stages = run_stages(tool, input, BuildStage::correspondences);
  const HandProfile profile = make_profile(stages, input.settings);
  if (output.empty()) tool.files().write(output = default_output(profile), FileKind::profile);
  write_hand_config(config_output, stages, input.settings);
  write_profile(profile, output);

  if (tool.json()) {
    std::cout << to_text(profile_summary_json(profile));
  } else if (!tool.quiet()) {
    print_profile(std::cout, profile, false);
    std::cout << '\n';
    print_findings(std::cout, profile.findings);
    std::cout << "\nWrote " << output << '\n';
  }
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-build-profile", argc, argv, build); }
