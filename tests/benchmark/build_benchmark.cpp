// build_benchmark: what building a profile costs against only loading the same meshes (docs/performance.md#build).
#include <cstdlib>
#include <iostream>
#include <optional>
#include <span>

#include "build_measurement.hpp"
#include "command_line/tool.hpp"
#include "hand_case.hpp"
#include "judgement.hpp"
#include "machine.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"

using namespace uhas;
using namespace uhas::benchmark;
using namespace uhas::tools;

namespace {

struct Options {
  std::vector<std::string> urdfs;
  std::string shared_hands = std::getenv("UHAS_HANDS_DIR") ? std::getenv("UHAS_HANDS_DIR") : "";
  bool quick = false, markdown = false;
  int rounds = 15;
};

void add_options(CLI::App& app, Options& options) {
  app.description(
      "Times the build of hand profiles, stage by stage, against only loading the same meshes with assimp, in turn, in "
      "one "
      "run. Without URDFs: the hands in the repository, and those in --hands.");
  app.add_option("urdf", options.urdfs, "Hands to measure")->type_name("URDF...");
  app.add_option("--hands", options.shared_hands,
                 "Folder of real hands (default: the environment variable UHAS_HANDS_DIR)")
      ->type_name("FOLDER");
  app.add_option("--rounds", options.rounds, "Builds of each hand")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_flag("--quick", options.quick, "One build of each, to see that it runs: its figures mean nothing");
  app.add_flag("--markdown", options.markdown, "Print the tables as Markdown");
}

/// Hands that the requirement on build time speaks of together.
struct Group {
  std::string name;
  std::span<const BuildMeasurement> hands;
};

std::vector<Judgement> hold_against_requirements(const std::vector<Group>& groups) {
  constexpr double megabyte = 1e6;
  std::vector<Judgement> judgements;
  std::optional<Judgement> memory;
  for (const Group& group : groups) {
    double build = 0, assimp = 0;
    for (const BuildMeasurement& hand : group.hands) {
      build += hand.build.median, assimp += hand.assimp.median;
      // the bound differs from hand to hand: 3 (aim 1.5) times the meshes and 100 (50) MB; the hand nearest
      // to it counts
      const double meshes = double(hand.mesh_memory) / megabyte, peak = double(hand.peak_memory) / megabyte;
      if (!memory || peak - 3 * meshes - 100 > memory->value - memory->must)
        memory = {"peak memory of a build, MB", true, 3 * meshes + 100, 1.5 * meshes + 50, peak, hand.hand};
    }
    judgements.push_back({"build: times loading the meshes", true, 4, 1.5, build / assimp, group.name});
  }
  judgements.push_back(*memory);
  return judgements;
}

std::string milliseconds(double ns) { return fixed(ns / 1e6, 2); }
std::string megabytes(std::size_t bytes) { return fixed(double(bytes) / 1e6, 1); }

const std::vector<std::string> kColumns{"hand",           "mesh files", "MB",  "meshes in memory, MB",
                                        "assimp, ms",     "build, ms",  "p99", "build / assimp",
                                        "peak memory, MB"};

std::vector<std::string> cells(const BuildMeasurement& hand) {
  return {hand.hand,
          std::to_string(hand.mesh_files),
          megabytes(hand.mesh_file_bytes),
          megabytes(hand.mesh_memory),
          milliseconds(hand.assimp.median),
          milliseconds(hand.build.median),
          milliseconds(hand.build.p99),
          fixed(hand.build.median / hand.assimp.median, 2),
          megabytes(hand.peak_memory)};
}

void print_tables(const std::vector<BuildMeasurement>& hands, std::ostream& out) {
  std::vector<Table::Column> columns, stage_columns{{"stage, ms"}};
  for (const std::string& column : kColumns) columns.push_back({column, columns.empty() ? Align::left : Align::right});
  Table table(columns);
  for (const BuildMeasurement& hand : hands) {
    const std::vector<std::string> row = cells(hand);
    table.add_row({row.begin(), row.end()});
    stage_columns.push_back({hand.hand, Align::right});
  }
  table.print(out);
  out << '\n';
  Table stages(stage_columns);
  for (std::size_t k = 0; k < hands.front().stages.size(); ++k) {
    std::vector<Table::Cell> row{hands.front().stages[k].stage};
    for (const BuildMeasurement& hand : hands) row.emplace_back(milliseconds(hand.stages[k].summary.median));
    stages.add_row(row);
  }
  stages.print(out);
  out << '\n';
}

void print_markdown(const std::vector<BuildMeasurement>& hands, std::ostream& out) {
  out << '\n';
  print_markdown_header(kColumns, out);
  for (const BuildMeasurement& hand : hands) print_markdown_row(cells(hand), out);
  out << '\n';
}

Json to_json(const Machine& machine, int rounds, const std::vector<BuildMeasurement>& hands,
             const std::vector<Judgement>& judgements) {
  const auto summary = [](const Summary& s) {
    return Json{{"median_ns", s.median}, {"p99_ns", s.p99}, {"worst_ns", s.worst}};
  };
  Json document = new_document("uhas-build-benchmark"), list = Json::array();
  for (const BuildMeasurement& hand : hands) {
    Json stages = Json::array();
    for (const StageTime& stage : hand.stages)
      stages.push_back({{"stage", stage.stage}, {"time", summary(stage.summary)}});
    list.push_back({{"hand", hand.hand},
                    {"mesh_files", hand.mesh_files},
                    {"mesh_file_bytes", hand.mesh_file_bytes},
                    {"mesh_memory_bytes", hand.mesh_memory},
                    {"assimp", summary(hand.assimp)},
                    {"build", summary(hand.build)},
                    {"stages", stages},
                    {"peak_memory_bytes", hand.peak_memory}});
  }
  document["machine"] = benchmark::to_json(machine);
  document["settings"] = {{"rounds", rounds}};
  document["hands"] = list;
  document["requirements"] = benchmark::to_json(judgements);
  return document;
}

ExitCode run(Tool& tool) {
  Options options;
  add_options(tool.options(), options);
  tool.parse();
  if (options.quick) options.rounds = 1;
  std::vector<std::filesystem::path> urdfs(options.urdfs.begin(), options.urdfs.end());
  std::size_t own = 0;
  if (urdfs.empty()) {
    own = find_hands(UHAS_OWN_HANDS_DIR, "").size();
    urdfs = find_hands(UHAS_OWN_HANDS_DIR, options.shared_hands);
  }

  Machine machine = this_machine();
  const std::vector<BuildMeasurement> hands = measure_builds(urdfs, options.rounds);
  machine.load_after = load_average();
  std::vector<Group> groups;
  if (own > 0) groups.push_back({"own hands", std::span(hands).first(own)});
  if (own < hands.size()) groups.push_back({own > 0 ? "shared hands" : "all hands", std::span(hands).subspan(own)});
  const std::vector<Judgement> judgements = hold_against_requirements(groups);
  if (tool.json()) {
    std::cout << to_text(to_json(machine, options.rounds, hands, judgements));
    return ExitCode::done;
  }
  print_machine(machine, std::cout);
  if (options.markdown) {
    print_markdown(hands, std::cout);
    print_markdown(judgements, std::cout);
  } else {
    print_tables(hands, std::cout);
    print_table(judgements, std::cout);
  }
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("build_benchmark", argc, argv, run); }
