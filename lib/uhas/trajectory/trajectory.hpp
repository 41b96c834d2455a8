// Trajectories (schemas/trajectory.schema.json): frames of joint values, read and written one at a time.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "uhas/fence/child_process.hpp"
#include "uhas/runtime/encoder.hpp"

namespace uhas {

/// How a trajectory lies in a file.
enum class TrajectoryKind { json, json_lines, hdf5 };

/// By the end of its name: .json, .jsonl, .h5 or .hdf5; nothing for any other.
std::optional<TrajectoryKind> trajectory_kind(const std::string& path);

/// What holds for every frame.
struct TrajectoryHeader {
  std::string hand;                      ///< the robot's name; empty when it is not stated
  std::vector<std::string> joint_names;  ///< order of the values of a frame
};

/// How far the frames were from what an action can give.
struct TrajectorySummary {
  static constexpr double kTolerance = 0.01;  ///< a frame closer than this is on the action manifold (rad)

  std::size_t frames = 0;
  std::size_t off_manifold = 0;  ///< frames farther away than the tolerance
  double residual_max = 0;       ///< largest of all frames (rad; sphere radii for a sliding joint)
  std::size_t worst_frame = 0;   ///< the first that is so far away, counted from 0
  double sum_of_squares = 0;     ///< of the frames' residual_rms

  void add(const EncodeReport& report);
  double residual_rms() const;
};

/// An open trajectory. JSON Lines and HDF5 are read in constant memory.
class TrajectoryReader {
 public:
  virtual ~TrajectoryReader() = default;
  const TrajectoryHeader& header() const { return header_; }

  /// The next frame into `q`, one value a joint name; false at the end.
  /// Throws Error(syntax), which names the frame.
  virtual bool next(std::vector<double>& q) = 0;

  /// The share that has been read, 0 to 1.
  virtual double progress() const = 0;

 protected:
  explicit TrajectoryReader(TrajectoryHeader header) : header_(std::move(header)) {}

 private:
  TrajectoryHeader header_;
};

/// What a file may have at most; JSON Lines may be of any length.
struct TrajectoryLimits {
  std::uint64_t max_json_bytes = 64u << 20;
  std::uint64_t max_hdf5_bytes = std::uint64_t{4} << 30;  ///< of all values together, unpacked
  ChildLimits in_child;                                   ///< of the process that reads HDF5
};

/// Throws Error: file_unreadable, limit_exceeded, syntax, unsupported_version.
std::unique_ptr<TrajectoryReader> open_trajectory(TrajectoryKind kind, const std::string& path,
                                                  const TrajectoryLimits& limits = {});

/// A trajectory being written. A file appears whole, by `finish`, or not at all.
class TrajectoryWriter {
 public:
  virtual ~TrajectoryWriter() = default;
  virtual void write(std::span<const double> q, const EncodeReport& report) = 0;  ///< throws Error(write_failed)
  virtual void finish(const TrajectorySummary& summary) = 0;                      ///< throws Error(write_failed)
};

/// Throws Error(write_failed).
std::unique_ptr<TrajectoryWriter> create_trajectory(TrajectoryKind kind, const std::string& path,
                                                    const TrajectoryHeader& header);

/// The same to a stream, which must outlive the writer: as JSON or JSON Lines.
std::unique_ptr<TrajectoryWriter> stream_trajectory(TrajectoryKind kind, std::ostream& out,
                                                    const TrajectoryHeader& header);

}  // namespace uhas
