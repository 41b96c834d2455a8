// The action: 5 + 5 V numbers that deform the sphere (docs/conventions.md#the-action).
#pragma once

#include <span>
#include <vector>

#include "uhas/base/export.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// What the numbers of an action mean. Data, so that a policy trained elsewhere runs without a change of code. The
/// default is uhas' own: use it for all that is new, and the values of the policy's training for a policy that exists
/// (`kUhasSim` in cascade_solver.hpp has those of the authors' released code). For another convention read "input" for
/// d_r and d_theta below.
struct ActionConvention {
  /// Radial inputs are displacements of the sphere, 0 = undeformed; with `true` its radii, 1 = undeformed.
  bool absolute_radii = false;
  /// From the palm pole to the first driving vector the displacement grows linearly from 0; with `true` it is that of
  /// the first driving vector throughout.
  bool held_toward_pole = false;
  /// 1; -1 where azimuth counts the other way round.
  int azimuth_sign = 1;
  /// Bounds of radial inputs, -1e6 <= lower <= 0 <= upper <= 1e6.
  double radial_lower = -kRadialBound, radial_upper = kRadialBound;

  friend bool operator==(const ActionConvention&, const ActionConvention&) = default;
};

/// One action, caller-owned. Any finite number is allowed.
template <class Real>
struct Action {
  /// [5 + 5 V], V = 1 to 4 driving vectors: [d_theta_0 .. d_theta_4, d_r_00 .. d_r_0(V-1), d_r_10 ..], slots pinky, ring,
  /// middle, index, thumb; the length says V. d_theta: rad, positive with the canonical azimuth, clamped to the bounds of
  /// the finger's lateral table. d_r: displacement in sphere radii, 0 = undeformed, clamped to [-2, 2].
  std::span<const Real> values;
  /// [V] for all slots or [5 V] slot by slot: polar angles, strictly increasing in (0, pi); empty = pi j / (V + 1).
  std::span<const Real> driving_vectors_phi{};
  /// Values are in [-1, 1]: 0 maps to 0, -1 and 1 to the bounds, linear between.
  bool normalized = false;
  /// [5] rad: a slot's plane stands this much further in canonical azimuth. Its finger turns along, within the bounds of
  /// d_theta; empty = 0. This, the next member and the angles above are for domain randomisation
  /// (docs/method.md#domain-randomisation): they change the action space of one call.
  std::span<const Real> azimuth_offsets{};
  /// [2] -1e6 <= lower <= 0 <= upper <= 1e6, in place of the convention's; empty = those.
  std::span<const Real> radial_bounds{};
};

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
