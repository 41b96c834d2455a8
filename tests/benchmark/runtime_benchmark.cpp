// runtime_benchmark: the runtime library against its peers and against what it promises (docs/performance.md#runtime).
#include <cstdlib>
#include <iostream>

#include "command_line/progress.hpp"
#include "command_line/tool.hpp"
#include "report.hpp"

using namespace uhas;
using namespace uhas::benchmark;
using namespace uhas::tools;

namespace {

constexpr std::size_t kActions = 4000;  // of each set; a multiple of the hands in any sample of single calls

struct Options {
  std::vector<std::string> urdfs;
  std::string shared_hands = std::getenv("UHAS_HANDS_DIR") ? std::getenv("UHAS_HANDS_DIR") : "";
  bool quick = false, markdown = false;
  unsigned seed = 1;
  RuntimeSettings settings;
  std::vector<int> growth_samples{6400, 64000, 640000};
};

void add_options(CLI::App& app, Options& options) {
  app.description(
      "Times the runtime library and its peers in turn, in one run, and holds the ratios against the requirements. "
      "Without URDFs: the hands in the repository, and those in --hands.");
  app.add_option("urdf", options.urdfs, "Hands to measure")->type_name("URDF...");
  app.add_option("--hands", options.shared_hands,
                 "Folder of real hands (default: the environment variable UHAS_HANDS_DIR)")
      ->type_name("FOLDER");
  app.add_option("--rounds", options.settings.rounds, "Samples of each work")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--single-solves", options.settings.tail_calls, "Solves that are timed one by one, for p99")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Of the random actions")->capture_default_str();
  app.add_flag("--quick", options.quick, "A few samples of everything, to see that it runs: its figures mean nothing");
  app.add_flag("--markdown", options.markdown, "Print the tables as Markdown");
}

RuntimeReport measure(const Tool& tool, const Options& options) {
  std::vector<std::filesystem::path> urdfs(options.urdfs.begin(), options.urdfs.end());
  if (urdfs.empty()) urdfs = find_hands(UHAS_OWN_HANDS_DIR, options.shared_hands);

  RuntimeReport report;
  report.machine = this_machine();
  report.seed = options.seed;
  report.settings = options.settings;
  Progress progress(tool, int(urdfs.size()) + 1);
  for (const std::filesystem::path& urdf : urdfs) {
    progress.begin(urdf.stem().c_str());
    const HandCase hand = make_hand_case(urdf, kActions, options.seed);
    report.hands.push_back(measure_hand(hand, options.settings));
    if (urdf != urdfs.back()) continue;
    progress.begin("growing profiles");
    report.growth = measure_point_growth(hand, options.growth_samples, options.settings);
  }
  report.machine.load_after = load_average();
  report.judgements = hold_against_requirements(report.hands, report.growth);
  return report;
}

ExitCode run(Tool& tool) {
  Options options;
  add_options(tool.options(), options);
  tool.parse();
  if (options.quick) {
    options.settings = {.rounds = 3, .tail_calls = 1000, .tail_runs = 1, .batch = 64};
    options.growth_samples = {6400, 64000};
  }
  const RuntimeReport report = measure(tool, options);
  if (tool.json())
    std::cout << to_text(to_json(report));
  else if (options.markdown)
    print_markdown(report, std::cout);
  else
    print_tables(report, std::cout);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("runtime_benchmark", argc, argv, run); }
