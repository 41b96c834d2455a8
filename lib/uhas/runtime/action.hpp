// The action: 5 + 5 V numbers that deform the sphere (design 2).
#pragma once

#include <array>
#include <span>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// One action, caller-owned: [d_theta_0 .. d_theta_4, d_r_00 .. d_r_0(V-1), d_r_10 ..], slots pinky, ring, middle, index, thumb.
/// d_theta: rad, positive with the canonical azimuth, clamped to the bounds of the finger's lateral table.
/// d_r: displacement in sphere radii, 0 = undeformed, clamped to [-2, 2].
template <class Real>
struct Action {
  std::span<const Real> values;               ///< [5 + 5 V], V = 1..4
  std::span<const Real> driving_vectors_phi{};  ///< [V] or [5 V] polar angles, strictly increasing in (0, pi); empty = pi j / (V + 1)
  bool normalized = false;                    ///< values in [-1, 1]: 0 maps to 0, -1 and 1 to the bounds, linear between
};

/// The deformation of one finger's driving plane: bounded, slots averaged.
template <class Real>
struct PlaneDeformation {
  Real delta_theta{};                              ///< rad, canonical
  int vectors = 2;                                 ///< V
  bool default_angles = true;                      ///< `phi` are pi j / (V + 1)
  std::array<Real, kMaxDrivingVectors> phi{};      ///< [V] polar angles of the driving vectors
  std::array<Real, kMaxDrivingVectors> delta_r{};  ///< [V] displacements, radii

  /// Displacement at polar angle `at`: 0 at the palm pole, linear between driving vectors, constant beyond the last one.
  Real radial(Real at) const;
};

}  // namespace uhas
