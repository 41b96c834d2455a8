// How far off the palm normal may be, by what its witnesses say of each other.
#pragma once

#include <optional>
#include <span>

#include "uhas/anatomy/fingers/digits.hpp"
#include "uhas/anatomy/palm/palm_slab.hpp"

namespace uhas {

struct NormalWitnesses {
  std::span<const Flexion> flexions;        ///< one a finger
  std::span<const FingerPosture> postures;  ///< one a finger, in the open pose
  const std::optional<PalmSlab>& slab;
  bool zero_is_straight;  ///< the hand's designer put straight fingers at zero
};

/// Standard error of the palm normal (rad). `anatomy` knows the thumb; `q` is the open pose.
double palm_normal_error(const Anatomy& anatomy, const PalmNormal& found, const NormalWitnesses& witnesses,
                         std::span<const double> q);

}  // namespace uhas
