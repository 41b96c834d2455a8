// Lateral look-up tables: joint value <-> fingertip azimuth on the wrapped hand (paper, section 3.4;
// docs/method.md#lateral-tables).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "uhas/lateral_tables/lateral_table_options.hpp"
#include "uhas/wrap/wrap.hpp"

namespace uhas {

struct LateralTables {
  std::vector<LateralTable> tables;  ///< one a lateral joint, in the order of the tree
  std::vector<int> table_of_finger;  ///< the table that drives the finger; -1 = none
  std::vector<double> q_sphere;      ///< wrapped pose, lateral joints at neutral; one value a joint of the tree
  std::vector<std::string> warnings;
};

/// Throws Error(invalid_config) for fewer than 11 steps.
LateralTables build_lateral_tables(const Anatomy& anatomy, const SphereFrame& frame,
                                   std::span<const JointClassification> classes, std::span<const double> q_closed,
                                   const LateralTableOptions& options = {});

}  // namespace uhas
