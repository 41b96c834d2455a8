// uhas-solve: actions become joint angles.
#include <iostream>
#include <optional>

#include "command_line/tool.hpp"
#include "input/actions.hpp"
#include "input/profile_input.hpp"
#include "output/report_page.hpp"
#include "output/solution.hpp"
#include "output/write_result.hpp"
#include "uhas/json/json_lines.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

struct Options {
  std::string actions, profile, output, html;
  ModelInput model;
  std::optional<SolveOptions> convention;
  std::optional<CascadeRule> rule;
  std::optional<CascadeClosing> closing;
  SolveOptions solve;  // field and passes
  JointSelection joints;
  CollisionUse collision;

  /// With the rule and the closing that were asked for, else those of the convention: the option's, else the file's.
  SolveOptions solve_options(const SolveOptions& convention_of_file) const {
    SolveOptions result = convention.value_or(convention_of_file);
    result.rule = rule.value_or(result.rule);
    result.closing = closing.value_or(result.closing);
    result.field = solve.field;
    result.passes = solve.passes;
    return result;
  }
};

void add_options(Tool& tool, Options& options) {
  CLI::App& app = tool.options();
  app.description("Turns actions, deformations of the sphere, into joint angles of a hand.");
  app.add_option("actions.json", options.actions, "Actions; - reads one action a line (JSON Lines) from standard input")
      ->required()
      ->type_name("FILE");
  app.add_option("--profile", options.profile, "Hand profile [the one that the actions file names]")->type_name("FILE");
  tool.add_output("-o,--output", options.output, FileKind::solution, "File to write the solution to [standard output]");
  std::vector<std::pair<std::string, std::optional<SolveOptions>>> conventions;
  for (const NamedConvention& convention : kConventions) conventions.emplace_back(convention.name, convention.options);
  add_choice(app, "--convention", options.convention, conventions,
             "What the numbers of an action mean [the one that the actions file names, else uhas]");
  add_choice<std::optional<CascadeRule>>(
      app, "--rule", options.rule, {{"correspondence", CascadeRule::correspondence}, {"contact", CascadeRule::contact}},
      "How a joint angle follows from the deformed sphere [correspondence]");
  add_choice<std::optional<CascadeClosing>>(app, "--closing", options.closing,
                                            {{"fade", CascadeClosing::fade}, {"hard", CascadeClosing::hard}},
                                            "How joints close as the sphere vanishes [fade]");
  add_choice<FieldReading>(app, "--field", options.solve.field,
                           {{"finger", FieldReading::finger}, {"field", FieldReading::field}},
                           "Which deformation a point takes: its finger's, or the interpolated one [finger]");
  app.add_option("--passes", options.solve.passes, "Sweeps over each finger; more come nearer to the optimum [1]")
      ->check(CLI::Range(1, 100).description(""))
      ->type_name("N");
  app.add_option("--joint-order", options.joints.order, "Joints to print, in this order [those of the profile]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("A,B,C");
  app.add_flag("--actuated-only", options.joints.actuated_only, "Leave out joints that follow another one");
  app.add_flag("--collisions", options.collision.report,
               "State with each solution which links come nearest to each other, and how near");
  app.add_flag("--avoid", options.collision.avoid,
               "Scale back actions whose solution has the hand collide with itself");
  add_html_option(tool, options.html,
                  "Draw also the solutions, played on the hand, as a page for any browser, offline");
  add_model_options(app, options.model);
}

ExitCode solve_stream(Tool& tool, const Options& options) {
  if (options.profile.empty()) throw Tool::wrong_usage("--profile", "needed when actions come from standard input");
  if (!options.output.empty()) throw Tool::wrong_usage("--output", "a stream of solutions goes to standard output");
  if (!options.html.empty()) throw Tool::wrong_usage("--html", "needs a file of actions");
  SolutionMaker maker(tool, {options.profile, read_profile(tool, options.profile)}, options.solve_options(kUhas),
                      options.joints, options.collision, options.model);
  const std::size_t failed = answer_json_lines(std::cin, std::cout, [&](const Json& value) {
    const std::vector<double> values = action_of(value);
    return maker.solve({.values = values}, "");
  });
  tool.warn(maker.warnings());
  if (failed == 0) return ExitCode::done;
  tool.report_error("standard input: " + std::to_string(failed) +
                    " of the lines could not be solved; see \"error\" in the output");
  return ExitCode::run_failed;
}

/// The page of a file of actions. Its sliders know one convention.
void write_page(Tool& tool, const Options& options, const ActionsDocument& document, const ProfileFile& file,
                const SolveOptions& solve) {
  if (solve.convention != ActionConvention{})
    throw Tool::wrong_usage("--html", "shows actions of uhas' own convention only");
  std::vector<ReportHand> hands =
      report_hands({&file, 1}, find_geometries(tool, {&file, 1}, options.model, "the picture lacks the meshes"));
  hands.front().timeline = {document.actions, document.driving_vectors_phi, document.normalized, solve};
  write_file(options.html, report_page(hands));
  tool.log("wrote " + options.html);
}

ExitCode solve_file(Tool& tool, const Options& options) {
  ActionsDocument document = read_actions(options.actions, tool.limits());
  const std::string profile_path = options.profile.empty() ? document.profile : options.profile;
  if (profile_path.empty())
    throw Tool::wrong_usage("--profile", "needed because " + options.actions + " does not name a hand profile");
  const SolveOptions solve = options.solve_options(document.convention);
  SolutionMaker maker(tool, {profile_path, read_profile(tool, profile_path)}, solve, options.joints, options.collision,
                      options.model);

  Json solutions = Json::array();
  for (std::size_t i = 0; i < document.actions.size(); ++i) {
    solutions.push_back(maker.solve(document.action(i), options.actions + ": action " + std::to_string(i)));
    document.actions[i] = maker.solved_values();
  }

  Json result = new_document("uhas-solution");
  result["hand"] = maker.file().profile.hand;
  result["joint_names"] = maker.joint_names();
  result["solutions"] = solutions;
  if (!options.html.empty()) write_page(tool, options, document, maker.file(), solve);
  write_result(options.output, to_text(result));
  tool.warn(maker.warnings());
  return ExitCode::done;
}

ExitCode run(Tool& tool) {
  Options options;
  add_options(tool, options);
  tool.parse();
  tool.limits().apply_to(options.model.load);
  if (!options.model.urdfs.empty() && options.html.empty() && !options.collision.report && !options.collision.avoid)
    throw Tool::wrong_usage("--urdf", "needs --collisions, --avoid or --html");
  return options.actions == "-" ? solve_stream(tool, options) : solve_file(tool, options);
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-solve", argc, argv, run); }
