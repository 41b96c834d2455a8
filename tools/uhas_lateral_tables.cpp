// uhas-lateral-tables: how far each lateral joint carries its fingertip around the sphere.
#include <iostream>

#include "input/hand_input.hpp"
#include "json/stage_json.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"
#include "text/words.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

/// The finger that a table drives, or a dash: of several lateral joints of a finger only one is driven.
std::string driven_finger(const BuildStages& stages, int table) {
  for (std::size_t i = 0; i < stages.anatomy.fingers.size(); ++i)
    if (stages.lateral_tables.table_of_finger[i] == table) return stages.sphere_frame.names[i];
  return "-";
}

void print(const BuildStages& stages) {
  Table table({{"joint"},
               {"drives"},
               {"neutral, deg", Align::right},
               {"azimuth there, deg", Align::right},
               {"from, deg", Align::right},
               {"to, deg", Align::right},
               {"samples", Align::right}});
  for (std::size_t i = 0; i < stages.lateral_tables.tables.size(); ++i) {
    const LateralTable& lateral = stages.lateral_tables.tables[i];
    table.add_row({stages.anatomy.tree.joints[lateral.joint].name, driven_finger(stages, static_cast<int>(i)),
                   degrees(lateral.neutral), degrees(lateral.theta_initial), degrees(lateral.delta_theta_lower),
                   degrees(lateral.delta_theta_upper), std::to_string(lateral.q.size())});
  }
  table.print(std::cout);
  std::cout << "From and to are relative to the azimuth at neutral.\n";
  std::vector<std::string> without;
  for (const int i : fingers_by_slot(stages.sphere_frame))
    if (stages.lateral_tables.table_of_finger[i] < 0) without.push_back(stages.sphere_frame.names[i]);
  if (!without.empty())
    std::cout << "Delta theta is ignored, for want of a lateral joint that moves the tip: " << join(without, ", ")
              << '\n';
}

ExitCode run(Tool& tool) {
  HandInput input;
  tool.options().description(
      "Shows the tables that turn a fingertip's azimuth on the sphere into a lateral joint's angle.");
  add_hand_options(tool.options(), input);
  add_lateral_options(tool.options(), input.settings.lateral_tables);
  tool.parse();

  const BuildStages stages = run_stages(tool, input, BuildStage::lateral_tables);
  if (tool.json())
    std::cout << to_text(lateral_tables_json(stages));
  else
    print(stages);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-lateral-tables", argc, argv, run); }
