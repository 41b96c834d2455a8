// What is measured on one hand: the runtime library's calls and their peers.
#pragma once

#include <string>
#include <vector>

#include "hand_case.hpp"
#include "measurement.hpp"

namespace uhas::benchmark {

struct RuntimeSettings {
  int rounds = 301;  ///< samples of each work
  std::size_t tail_calls = 1'000'000;
  int tail_runs = 5;
  std::size_t batch = 8192;  ///< hands in a batch
};

struct Measured {
  std::string work;
  std::size_t hands;  ///< in one sample
  Summary summary;    ///< ns a hand
};

/// How well a peer did on the trajectory.
struct PeerAnswers {
  std::string peer;
  double reached = 0;        ///< share of fingertips within 1 mm of their targets
  double within_limits = 0;  ///< share of hands with every joint within its limits
};

struct ObjectSize {
  std::string object;
  std::size_t size_of;  ///< sizeof, bytes
  std::size_t heap;     ///< bytes that it allocates, as malloc counts them
};

struct HandMeasurement {
  std::string hand;
  std::size_t fingers = 0, joints = 0, independent_joints = 0, stored_points = 0, solver_points = 0;
  std::vector<Measured> works;
  std::vector<PeerAnswers> peers;
  Tail gentle_tail, any_tail,
      encode_tail;  ///< of single solves, and of encoding what the any-range ones gave, in double
  std::vector<ObjectSize> sizes;

  /// Of a work, ns a hand. Throws std::out_of_range for one that was not measured.
  const Summary& summary(const std::string& work) const;
  double median(const std::string& work) const { return summary(work).median; }
};

HandMeasurement measure_hand(const HandCase& hand, const RuntimeSettings& settings);

/// Solves on profiles of one hand that store ever more points.
struct PointGrowth {
  struct Row {
    std::size_t stored_points, solver_points;
    Summary solve;  ///< ns a hand
  };
  std::string hand;
  std::vector<Row> rows;
};

/// `samples`: directions cast from the sphere's centre, one profile each.
PointGrowth measure_point_growth(const HandCase& hand, const std::vector<int>& samples,
                                 const RuntimeSettings& settings);

}  // namespace uhas::benchmark
