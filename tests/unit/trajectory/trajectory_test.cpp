// Trajectories: the same frames from every kind of file, mistakes with their places, files whole or not at all.
#include "uhas/trajectory/trajectory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

using Frames = std::vector<std::vector<double>>;

const TrajectoryHeader kHeader{.hand = "toy", .joint_names = {"a", "knuckle"}};

/// More frames than a block of an HDF5 file or of the process that reads one holds.
Frames many_frames() {
  Frames frames;
  for (int i = 0; i < 9'000; ++i) frames.push_back({i / 3.0, -i / 7.0});
  return frames;
}

void write(TrajectoryWriter& writer, const Frames& frames) {
  TrajectorySummary summary;
  for (const std::vector<double>& frame : frames) {
    const EncodeReport report{.residual_max = 0.02, .residual_rms = 0.01};
    summary.add(report);
    writer.write(frame, report);
  }
  writer.finish(summary);
}

Frames read(const std::string& path, const TrajectoryLimits& limits = {}) {
  const std::unique_ptr<TrajectoryReader> reader = open_trajectory(*trajectory_kind(path), path, limits);
  CHECK(reader->header().joint_names == kHeader.joint_names);
  Frames frames;
  double progress = 0;
  for (std::vector<double> frame; reader->next(frame);) {
    frames.push_back(frame);
    CHECK(reader->progress() >= progress);
    progress = reader->progress();
  }
  CHECK(reader->progress() == doctest::Approx(1));
  return frames;
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the kind is told by the end of the name") {
  CHECK(trajectory_kind("a.h5.json") == TrajectoryKind::json);
  CHECK(trajectory_kind("a.jsonl") == TrajectoryKind::json_lines);
  CHECK(trajectory_kind("a.h5") == TrajectoryKind::hdf5);
  CHECK(trajectory_kind("a.hdf5") == TrajectoryKind::hdf5);
  CHECK_FALSE(trajectory_kind("a.csv").has_value());
  CHECK_FALSE(trajectory_kind("json").has_value());
}

TEST_CASE("what is written is read again, bit by bit") {
  const ScratchFolder folder;
  const Frames frames = many_frames();
  for (const char* name : {"t.json", "t.jsonl", "t.h5"}) {
    CAPTURE(name);
    const std::string path = folder.file(name);
    write(*create_trajectory(*trajectory_kind(path), path, kHeader), frames);
    CHECK(read(path) == frames);
    CHECK(open_trajectory(*trajectory_kind(path), path)->header().hand == "toy");
  }
}

TEST_CASE("a stream gets the text that a file gets") {
  const ScratchFolder folder;
  for (const TrajectoryKind kind : {TrajectoryKind::json, TrajectoryKind::json_lines}) {
    const std::string path = folder.file("t");
    std::ostringstream out;
    write(*create_trajectory(kind, path, kHeader), {{1, 2}, {3, 4}});
    write(*stream_trajectory(kind, out, kHeader), {{1, 2}, {3, 4}});
    CHECK(out.str() == text_of(path));
  }
}

TEST_CASE("a writer that is left before its end leaves the old file as it was") {
  const ScratchFolder folder;
  for (const char* name : {"t.json", "t.jsonl", "t.h5"}) {
    const std::string path = folder.write(name, "old");
    create_trajectory(*trajectory_kind(path), path, kHeader)->write(std::vector<double>{1, 2}, {});
    CHECK(text_of(path) == "old");
  }
}

TEST_CASE("mistakes are refused with their places") {
  const ScratchFolder folder;
  const std::string header = R"({"format": "uhas-trajectory", "version": 1, "joint_names": ["a", "knuckle"])";
  const std::string lines = folder.write("t.jsonl", header + "}\n[1, 2]\n\n[3]\n");
  check_error(ErrorCode::syntax, "t.jsonl:4: has 1 values for 2 joints", [&] { read(lines); });
  const std::string document = folder.write("t.json", header + R"(, "q": [[1, 2], "x"]})");
  check_error(ErrorCode::syntax, "t.json: frame 1: is not a frame", [&] { read(document); });
  check_error(ErrorCode::syntax, "does not open with the order of the joints",
              [&] { read(folder.write("u.jsonl", "[1, 2]\n")); });
  check_error(ErrorCode::unsupported_version, "version is 2",
              [&] { read(folder.write("u.json", R"({"format": "uhas-trajectory", "version": 2, "q": []})")); });
  check_error(ErrorCode::file_unreadable, "does not exist", [&] { read(folder.file("none.h5")); });
}

TEST_CASE("bounds are named by their fields") {
  const ScratchFolder folder;
  for (const char* name : {"t.json", "t.h5"})
    write(*create_trajectory(*trajectory_kind(name), folder.file(name), kHeader), {{1, 2}});
  TrajectoryLimits limits;
  limits.max_json_bytes = limits.max_hdf5_bytes = 10;
  check_error(ErrorCode::limit_exceeded, "raise TrajectoryLimits::max_json_bytes",
              [&] { read(folder.file("t.json"), limits); });
  check_error(ErrorCode::limit_exceeded, "raise TrajectoryLimits::max_hdf5_bytes",
              [&] { read(folder.file("t.h5"), limits); });
}

TEST_CASE("the summary counts frames off the action manifold") {
  TrajectorySummary summary;
  CHECK(summary.residual_rms() == 0);
  summary.add({.residual_max = 0.005, .residual_rms = 3});
  summary.add({.residual_max = 0.5, .residual_rms = 4});
  summary.add({.residual_max = 0.5, .residual_rms = 0});
  CHECK(summary.frames == 3);
  CHECK(summary.off_manifold == 2);
  CHECK(summary.worst_frame == 1);
  CHECK(summary.residual_max == 0.5);
  CHECK(summary.residual_rms() == doctest::Approx(std::sqrt(25.0 / 3)));
}
