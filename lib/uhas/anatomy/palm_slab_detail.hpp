// The palm as a slab: how its surface lies, whatever the joints say.
#pragma once

#include <optional>

#include "uhas/anatomy/anatomy.hpp"

namespace uhas {

/// Standard error of a slab's axis against the palm normal (rad): 5 degrees on Shadow, under 1 on other real hands.
inline constexpr double kSlabError = 0.1;

/// The thinnest axis of the palm's surface, unit, in P, pointing to either side; nothing when the palm has no geometry or
/// is no slab. Reads the palm's links.
std::optional<Vector3d> find_palm_slab(const HandModel& model, const Anatomy& anatomy);

}  // namespace uhas
