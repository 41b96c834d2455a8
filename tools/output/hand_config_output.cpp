#include "output/hand_config_output.hpp"

#include "json/hand_explanation_json.hpp"
#include "output/write_result.hpp"

namespace uhas::tools {

void add_write_config_option(Tool& tool, std::string& path) {
  tool.add_output("--write-config", path, FileKind::hand_config,
                  "Also write what was found as a hand config, to be corrected and given to --config");
}

void write_hand_config(const std::string& path, const BuildStages& stages, const BuildSettings& settings) {
  if (path.empty()) return;
  write_result(path, to_text(hand_config_json(stages, settings)));
}

}  // namespace uhas::tools
