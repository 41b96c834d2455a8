// The action: 5 + 5 V numbers that deform the sphere (design 2).
#pragma once

#include <span>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// One action, caller-owned: [d_theta_0 .. d_theta_4, d_r_00 .. d_r_0(V-1), d_r_10 ..], slots pinky, ring, middle, index, thumb.
/// d_theta: rad, positive with the canonical azimuth, clamped to the bounds of the finger's lateral table.
/// d_r: displacement in sphere radii, 0 = undeformed, clamped to [-2, 2].
template <class Real>
struct Action {
  std::span<const Real> values;                 ///< [5 + 5 V], V = 1..4
  std::span<const Real> driving_vectors_phi{};  ///< [V] or [5 V] polar angles, strictly increasing in (0, pi); empty = pi j / (V + 1)
  bool normalized = false;                      ///< values in [-1, 1]: 0 maps to 0, -1 and 1 to the bounds, linear between
};

}  // namespace uhas
