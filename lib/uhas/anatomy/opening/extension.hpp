// How a finger stands when it is extended: straight, and at which angle to the palm.
#pragma once

#include <optional>
#include <span>

#include "uhas/anatomy/opening/flexion.hpp"
#include "uhas/anatomy/palm/palm_slab.hpp"

namespace uhas {

/// What the rest of the hand knows about the angle between a finger's base and the palm.
struct BaseEvidence {
  bool zero_is_straight = false;  ///< the hand's fingers are straight at zero, so zero is where its designer opened it
  std::optional<PalmSlab> slab;
};

/// Extends the finger in `q`: distal flexion joints straight, the first one at a zero that its designer called
/// straight, else straight with what comes before it, else square to the palm's slab, else just short of the open end;
/// a side joint before it has a say. Other joints keep their values. Sets `base_error` and `base_is_guess`.
void extend_finger(const Anatomy& anatomy, const FingerAnatomy& finger, const BaseEvidence& evidence, Flexion& flexion,
                   std::span<double> q);

}  // namespace uhas
