// uhas-explain-hand: what is inferred of a hand, how surely, and why.
#include <iostream>

#include "input/hand_input.hpp"
#include "json/hand_explanation_json.hpp"
#include "output/hand_config_output.hpp"
#include "tables/hand_explanation_table.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

ExitCode explain(Tool& tool) {
  HandInput input;
  std::string config_output;
  tool.options().description("Tells what is inferred of a robot hand from its URDF, how surely, and why.");
  add_hand_options(tool.options(), input);
  add_write_config_option(tool, config_output);
  tool.parse();

  const BuildStages stages = run_stages(tool, input, BuildStage::classification);
  write_hand_config(config_output, stages, input.settings);
  if (tool.json())
    std::cout << to_text(hand_explanation_json(stages, input.settings));
  else
    print_hand_explanation(std::cout, stages);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-explain-hand", argc, argv, explain); }
