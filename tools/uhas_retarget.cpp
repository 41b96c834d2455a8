// uhas-retarget: a trajectory of one hand becomes one of another.
#include <iostream>

#include "command_line/progress.hpp"
#include "command_line/tool.hpp"
#include "input/joint_order.hpp"
#include "input/profile_input.hpp"
#include "text/numbers.hpp"
#include "uhas/json/json_lines.hpp"
#include "uhas/runtime/retarget.hpp"
#include "uhas/trajectory/trajectory_json.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

constexpr std::size_t kFramesBetweenProgress = 64;

struct Options {
  std::string from, to, trajectory, output;
  int driving_vectors = 2;
};

void add_options(Tool& tool, Options& options) {
  CLI::App& app = tool.options();
  app.description("Carries a trajectory of joint values from one hand to another.");
  app.add_option("trajectory", options.trajectory,
                 "Trajectory: .json, .jsonl or .h5; - reads one frame a line (JSON Lines) from standard input")
      ->required()
      ->type_name("FILE");
  app.add_option("--from", options.from, "Profile of the hand that was recorded")->required()->type_name("FILE");
  app.add_option("--to", options.to, "Profile of the hand that is to move so")->required()->type_name("FILE");
  tool.add_output("-o,--output", options.output, FileKind::trajectory,
                  "File to write to: .json, .jsonl or .h5 [standard output]");
  app.add_option("--driving-vectors", options.driving_vectors,
                 "Driving vectors in each plane; more follow the first hand more closely [2]")
      ->check(CLI::Range(1, kMaxDrivingVectors).description(""))
      ->type_name("N");
}

/// Two hands and what lies between them.
struct Retargeting {
  Retargeting(Tool& tool, const Options& options)
      : from(read_profile(tool, options.from)),
        to(read_profile(tool, options.to)),
        retargeter(from, to, {}, options.driving_vectors),
        order(from),
        q_from(from.tree.joints.size()),
        q_to(to.tree.joints.size()) {}

  /// A row of the trajectory to `q_to`. Throws Error(syntax) in the name of `place`.
  EncodeReport run(std::span<const double> row, const std::string& place) {
    order.reorder(row, q_from);
    EncodeReport report;
    if (const Status status = retargeter.retarget(q_from, q_to, report); status != Status::ok)
      throw Error(ErrorCode::syntax, place, to_string(status), "");
    summary.add(report);
    return report;
  }

  TrajectoryHeader header() const {
    TrajectoryHeader result{.hand = to.hand, .joint_names = {}};
    for (const Joint& joint : to.tree.joints) result.joint_names.push_back(joint.name);
    return result;
  }

  HandProfile from, to;
  Retargeter<double> retargeter;
  JointOrder order;
  std::vector<double> q_from, q_to;
  TrajectorySummary summary;
};

/// A left hand's trajectory often names its joints as the right hand does.
void warn_of_other_hand(const Tool& tool, const std::string& hand, const HandProfile& from) {
  if (hand.empty() || hand == from.hand) return;
  tool.warn(std::array{"the trajectory is of " + hand + ", the profile of --from is of " + from.hand});
}

void print_summary(const Tool& tool, const Retargeting& run) {
  const TrajectorySummary& summary = run.summary;
  if (tool.json()) {
    Json document = new_document("uhas-retarget-summary");
    document["from"] = run.from.hand, document["to"] = run.to.hand;
    document["summary"] = to_json(summary);
    std::cout << to_text(document);
    return;
  }
  std::cout << "Retargeted " << summary.frames << " frames from " << run.from.hand << " to " << run.to.hand << '\n';
  if (summary.frames == 0) return;
  std::cout << "Distance from what an action can give: rms " << fixed(summary.residual_rms(), 4) << " rad, worst "
            << fixed(summary.residual_max, 4) << " rad in frame " << summary.worst_frame << "; above "
            << fixed(TrajectorySummary::kTolerance, 2) << " rad in " << summary.off_manifold << " frames\n";
}

ExitCode retarget_stream(Tool& tool, const Options& options) {
  if (!options.output.empty()) throw Tool::wrong_usage("--output", "a stream of frames goes to standard output");
  Retargeting run(tool, options);
  const std::size_t failed = answer_json_lines(std::cin, std::cout, [&](const Json& value) {
    if (const std::optional<TrajectoryHeader> header = header_of(value, "header")) {
      run.order = JointOrder(run.from, header->joint_names, "header");
      warn_of_other_hand(tool, header->hand, run.from);
      return to_json(run.header());
    }
    const EncodeReport report = run.run(frame_of(value, run.order.row_size(), "frame"), "frame");
    return to_json(run.q_to, report);
  });
  std::cout << to_line({{"summary", to_json(run.summary)}});
  if (failed == 0) return ExitCode::done;
  tool.report_error("standard input: " + std::to_string(failed) +
                    " of the lines could not be retargeted; see \"error\" in the output");
  return ExitCode::run_failed;
}

TrajectoryKind kind_of(const std::string& path) {
  if (const std::optional<TrajectoryKind> kind = trajectory_kind(path)) return *kind;
  throw Tool::wrong_usage(path, "the name of a trajectory ends in .json, .jsonl, .h5 or .hdf5");
}

/// To a file, or for an empty path to standard output: in JSON when that is asked for, else in JSON Lines.
std::unique_ptr<TrajectoryWriter> make_writer(TrajectoryKind kind, const std::string& path,
                                              const TrajectoryHeader& header) {
  if (!path.empty()) return create_trajectory(kind, path, header);
  const bool whole = kind == TrajectoryKind::json;
  return stream_trajectory(whole ? TrajectoryKind::json : TrajectoryKind::json_lines, std::cout, header);
}

ExitCode retarget_file(Tool& tool, const Options& options) {
  const TrajectoryKind kind = kind_of(options.trajectory);
  const TrajectoryKind output_kind = options.output.empty() ? kind : kind_of(options.output);
  Retargeting run(tool, options);
  const std::unique_ptr<TrajectoryReader> reader =
      open_trajectory(kind, options.trajectory, tool.limits().trajectory());
  run.order = JointOrder(run.from, reader->header().joint_names, options.trajectory);
  warn_of_other_hand(tool, reader->header().hand, run.from);
  const std::unique_ptr<TrajectoryWriter> writer = make_writer(output_kind, options.output, run.header());

  {
    Progress progress(tool, 1);
    progress.begin("retargeting");
    for (std::vector<double> row; reader->next(row);) {
      const EncodeReport report = run.run(row, options.trajectory + ": frame " + std::to_string(run.summary.frames));
      writer->write(run.q_to, report);
      if (run.summary.frames % kFramesBetweenProgress == 0) progress.advance(reader->progress());
    }
  }
  writer->finish(run.summary);
  if (!options.output.empty()) print_summary(tool, run);
  return ExitCode::done;
}

ExitCode run(Tool& tool) {
  Options options;
  add_options(tool, options);
  tool.parse();
  return options.trajectory == "-" ? retarget_stream(tool, options) : retarget_file(tool, options);
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-retarget", argc, argv, run); }
