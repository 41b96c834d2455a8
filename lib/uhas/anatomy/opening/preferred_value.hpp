// The neutral value of a joint: the one search for joint values of this room.
#pragma once

#include <functional>

#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// The value of `joint` that a designer would call neutral among those that do well: zero when its
/// `objective` is within `tolerance` of the best of the range; on a flat objective the middle of the range, unless zero
/// lies near it; else the best value.
/// @param zero_is_neutral  false on a hand whose zeros say nothing: then zero is a value like others
double preferred_value(const Joint& joint, double tolerance, bool zero_is_neutral,
                       const std::function<double(double)>& objective);

}  // namespace uhas
