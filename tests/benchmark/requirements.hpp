// The performance that uhas promises (docs/performance.md), held against what was measured.
#pragma once

#include <vector>

#include "judgement.hpp"
#include "runtime_measurement.hpp"

namespace uhas::benchmark {

/// Where a promise is about a five-finger hand of twenty joints: hands with at least as many, or, when none was measured,
/// all that were. `growth` may have no rows.
std::vector<Judgement> hold_against_requirements(const std::vector<HandMeasurement>& hands, const PointGrowth& growth);

}  // namespace uhas::benchmark
