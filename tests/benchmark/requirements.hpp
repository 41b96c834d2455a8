// The performance that uhas promises (design 7), held against what was measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime_measurement.hpp"

namespace uhas::benchmark {

enum class Verdict { aim, must, missed };

struct Judgement {
  std::string requirement;
  bool at_most;  ///< the value may not be above `must`; else not below
  double must, aim;
  double value;      ///< a ratio; of several hands that of the worst
  std::string hand;  ///< the worst
  Verdict verdict() const;
};

/// Where the design speaks of a five-finger hand of twenty joints: hands with at least as many, or, when none was
/// measured, all that were. `growth` may have no rows.
std::vector<Judgement> hold_against_requirements(const std::vector<HandMeasurement>& hands, const PointGrowth& growth);

}  // namespace uhas::benchmark
