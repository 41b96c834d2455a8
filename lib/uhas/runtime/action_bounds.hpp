// The bounds of an action's numbers: what a learner's action space is.
#pragma once

#include <vector>

#include "uhas/base/export.hpp"
#include "uhas/runtime/action.hpp"

namespace uhas {

/// Numbers beyond their bounds are clamped to them. [5 + 5 V] in the order of `Action::values`: d_theta in rad, d_r in
/// sphere radii. Both bounds of a number that no finger reads are 0: d_theta of a finger without a lateral table, and the
/// numbers of a slot that no finger has.
struct ActionBounds {
  std::vector<double> lower, upper;
};

/// Of actions that are not normalised: the bounds of normalised numbers are -1 and 1. An action's own `radial_bounds` take
/// the place of those of d_r.
/// @param driving_vectors  V, 1 to 4
/// Throws Error: invalid_profile for a profile that `validate_profile` refuses, invalid_option for V or numbers of the
/// convention out of range.
UHAS_API ActionBounds action_bounds(const HandProfile& profile, int driving_vectors = 2,
                                    const ActionConvention& convention = {});

}  // namespace uhas
