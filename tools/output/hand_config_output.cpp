#include "output/hand_config_output.hpp"

#include "json/hand_explanation_json.hpp"
#include "output/write_result.hpp"

namespace uhas::tools {

void add_write_config_option(CLI::App& app, std::string& path) {
  app.add_option("--write-config", path,
                 "Also write what was found as a hand config, to be corrected and given to --config")
      ->type_name("FILE");
}

void write_hand_config(const std::string& path, const BuildStages& stages, const BuildSettings& settings) {
  if (path.empty()) return;
  write_result(path, to_text(hand_config_json(stages, settings)));
}

}  // namespace uhas::tools
