// The action: 5 + 5 V numbers that deform the sphere (docs/conventions.md#the-action).
#pragma once

#include <span>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// What the numbers of an action mean. Data, so that a policy trained elsewhere runs without a change of code; the
/// default is uhas' own. For another convention read "input" for d_r and d_theta below.
struct ActionConvention {
  /// Radial inputs are radii of the sphere (1 = undeformed) instead of displacements from it.
  bool absolute_radii = false;
  /// The first driving vector's displacement holds from the palm pole on, instead of 0 at the pole and linear from
  /// there.
  bool held_toward_pole = false;
  int azimuth_sign = 1;  ///< 1, or -1 where azimuth counts the other way round
  double radial_lower = -kRadialBound, radial_upper = kRadialBound;  ///< bounds of radial inputs; lower <= 0 <= upper

  friend bool operator==(const ActionConvention&, const ActionConvention&) = default;
};

/// One action, caller-owned: [d_theta_0 .. d_theta_4, d_r_00 .. d_r_0(V-1), d_r_10 ..], slots pinky, ring, middle,
/// index, thumb. d_theta: rad, positive with the canonical azimuth, clamped to the bounds of the finger's lateral
/// table. d_r: displacement in sphere radii, 0 = undeformed, clamped to [-2, 2]. Placed vectors, offsets and bounds are
/// for domain randomisation (docs/method.md#domain-randomisation): they change the action space of one call.
template <class Real>
struct Action {
  std::span<const Real> values;  ///< [5 + 5 V], V = 1..4
  /// [V] or [5 V] polar angles, strictly increasing in (0, pi); empty = pi j / (V + 1).
  std::span<const Real> driving_vectors_phi{};
  bool normalized = false;  ///< values in [-1, 1]: 0 maps to 0, -1 and 1 to the bounds, linear between
  /// [5] rad: a slot's plane stands this much further in canonical azimuth. Its finger turns along, within the bounds
  /// of d_theta; empty = 0.
  std::span<const Real> azimuth_offsets{};
  /// [2] -1e6 <= lower <= 0 <= upper <= 1e6, in place of the convention's; empty = those.
  std::span<const Real> radial_bounds{};
};

}  // namespace uhas
