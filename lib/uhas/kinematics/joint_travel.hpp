// The way of a joint from open toward closed, on which contacts are sought.
#pragma once

#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// Where a joint stands open, its closed end, and its opposite (open) end. rad, or lengths.
template <class Real>
struct JointTravel {
  Real open{}, closed{}, opposite{};

  /// The same with lengths in `unit`.
  template <class To>
  JointTravel<To> in_units_of(Real unit) const {
    return {static_cast<To>(open / unit), static_cast<To>(closed / unit), static_cast<To>(opposite / unit)};
  }
};

/// The opposite end is the limit farther from `q_closed`. rad or m.
inline JointTravel<double> travel_of(const Joint& joint, double q_open, double q_closed) {
  const bool closes_upward = joint.upper - q_closed <= q_closed - joint.lower;
  return {q_open, q_closed, closes_upward ? joint.lower : joint.upper};
}

}  // namespace uhas
