// uhas-evaluate: how good a hand profile is, in scores.
#include <algorithm>
#include <iostream>
#include <thread>

#include "command_line/tool.hpp"
#include "input/model_input.hpp"
#include "input/profile_input.hpp"
#include "json/evaluation_json.hpp"
#include "output/report_page.hpp"
#include "output/write_result.hpp"
#include "tables/evaluation_table.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

struct Options {
  std::vector<std::string> profiles;
  EvaluationOptions evaluation;
  ModelInput model;
  std::string html;
  bool markdown = false;
};

void add_options(Tool& tool, Options& options) {
  CLI::App& app = tool.options();
  app.description("Scores a hand profile: reach, fit, surface, smoothness, self-collision and time of a solve.");
  app.add_option("profile.h5", options.profiles, "Hand profile; several are shown side by side")
      ->required()
      ->option_text("FILE... REQUIRED");
  app.add_option("--actions", options.evaluation.battery.actions, "Random actions that the hand is judged by [400]")
      ->check(CLI::Range(1, 1'000'000).description(""))
      ->type_name("N");
  app.add_option("--seed", options.evaluation.battery.seed, "Of the random actions and lines [1]")->type_name("N");
  app.add_option("--lines", options.evaluation.smoothness_lines,
                 "Random lines along which joint steps are looked for [400]")
      ->check(CLI::Range(0, 1'000'000).description(""))
      ->type_name("N");
  app.add_option("--threads", options.evaluation.threads,
                 "Threads to work on [all processors]; the scores do not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N");
  add_html_option(tool, options.html, "Also draw the hands with their scores as a page for any browser, offline");
  app.add_flag("--markdown", options.markdown, "Print the scores of all hands as a Markdown table");
  add_model_options(app, options.model);
}

/// The hand's name, with the file's where two hands have one name.
std::string label_of(const std::vector<ProfileFile>& files, const ProfileFile& file) {
  const auto same =
      std::ranges::count_if(files, [&](const ProfileFile& other) { return other.profile.hand == file.profile.hand; });
  return same == 1 ? file.profile.hand : file.profile.hand + " (" + file.path + ")";
}

ExitCode run(Tool& tool) {
  Options options;
  options.evaluation.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  add_options(tool, options);
  tool.parse();
  tool.limits().apply_to(options.model.load);
  if (tool.json() && options.markdown) throw Tool::wrong_usage("--markdown", "cannot be printed as JSON too");

  std::vector<ProfileFile> files;
  for (const std::string& path : options.profiles) files.push_back({path, read_profile(tool, path)});
  const std::vector<HandGeometry> geometries =
      find_geometries(tool, files, options.model, "self-collision is not scored");

  EvaluationRun run{.options = options.evaluation, .hands = {}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    tool.log("evaluating " + files[i].path);
    const HandGeometry* geometry = geometries[i].links.empty() ? nullptr : &geometries[i];
    run.hands.push_back(
        {label_of(files, files[i]), files[i].profile, evaluate_hand(files[i].profile, geometry, options.evaluation)});
  }

  if (!options.html.empty()) {
    std::vector<ReportHand> hands = report_hands(files, geometries);
    for (std::size_t i = 0; i < hands.size(); ++i)
      hands[i].evaluation_json = evaluation_json(run, {&run.hands[i], 1}).dump();
    write_file(options.html, report_page(hands));
  }
  if (tool.json())
    std::cout << to_text(evaluation_json(run, run.hands));
  else if (options.markdown)
    print_evaluation_markdown(std::cout, run);
  else
    print_evaluation(std::cout, run);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-evaluate", argc, argv, run); }
