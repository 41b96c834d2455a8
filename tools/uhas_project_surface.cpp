// uhas-project-surface: which points of the hand's surface the sphere sees.
#include <iostream>

#include "input/hand_input.hpp"
#include "json/stage_json.hpp"
#include "output/write_result.hpp"
#include "text/table.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

void print(const BuildStages& stages) {
  Table table({{"link"}, {"points", Align::right}, {"too far", Align::right}, {"facing away", Align::right}});
  for (std::size_t i = 0; i < stages.correspondences.hits.size(); ++i) {
    const LinkHits& hits = stages.correspondences.hits[i];
    if (hits.kept + hits.too_far + hits.facing_away == 0) continue;  // inside another link, or without geometry
    table.add_row({stages.anatomy.links[i].name, std::to_string(hits.kept), std::to_string(hits.too_far),
                   std::to_string(hits.facing_away)});
  }
  table.print(std::cout);
  std::cout << stages.correspondences.points.size() << " surface points in all\n";
}

ExitCode run(Tool& tool) {
  HandInput input;
  std::string output;
  tool.options().description(
      "Casts rays from the sphere's centre and shows which points of the wrapped hand they meet.");
  add_hand_options(tool.options(), input);
  add_lateral_options(tool.options(), input.settings.lateral_tables);
  add_surface_options(tool.options(), input.settings.correspondences);
  tool.add_output("-o,--output", output, FileKind::surface_points, "Also write every point to this file, as JSON");
  tool.parse();

  const BuildStages stages = run_stages(tool, input, BuildStage::correspondences);
  if (!output.empty()) write_result(output, to_text(surface_points_json(stages)));
  if (tool.json())
    std::cout << to_text(surface_hits_json(stages));
  else
    print(stages);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-project-surface", argc, argv, run); }
