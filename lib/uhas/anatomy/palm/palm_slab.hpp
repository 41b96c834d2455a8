// The palm as a slab: how its surface lies, whatever the joints say.
#pragma once

#include <optional>

#include "uhas/anatomy/palm/palm_tree.hpp"

namespace uhas {

struct PalmSlab {
  Vector3d normal;   ///< thinnest axis of the palm's surface, unit, in P, pointing to either side
  double error = 0;  ///< of its angle to the palm normal (rad, a standard error)
};

/// Nothing when the palm has no geometry or is no slab.
/// @param knuckle_center  in P: a palm reaches toward it, and a slab that does not is tilted
std::optional<PalmSlab> find_palm_slab(const HandModel& model, const PalmTree& palm, Vector3d knuckle_center);

}  // namespace uhas
