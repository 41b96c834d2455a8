// How a hand's surface lies on the sphere: how far off it is when posed, and how much of the sphere its points see.
#pragma once

#include <span>
#include <vector>

#include "uhas/evaluation/quantiles.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

struct FingerSurface {
  Quantiles at_rest;   ///< distance of the finger's correspondences from the undeformed sphere, sphere radii
  Quantiles deformed;  ///< from the deformed sphere, over the actions
  double phi_least = 0, phi_greatest = 0;  ///< polar angles of its correspondences, rad
  double phi_gap = 0;                      ///< the widest stretch between these without a correspondence, rad
};

struct SurfaceScore {
  std::vector<FingerSurface> fingers;  ///< [finger of the profile]; zero for one without correspondences
  Quantiles at_rest, deformed;         ///< over all fingers
  double coverage = 0;      ///< share of the palm's hemisphere, by area, that holds a correspondence, palm's too, in
                            ///< cells of about 9 degrees
  double largest_hole = 0;  ///< rad: from the direction of that hemisphere that is farthest from any correspondence
};

/// A posed point is as far from the deformed sphere as its distance from the centre differs from the sphere's radius
/// at its own polar angle, 1 + delta r of its finger's plane. Points where the sphere has vanished (a radius below 0)
/// are left out.
/// @param battery  [N][15]
/// @param threads  at least 1; the score does not depend on it
SurfaceScore measure_surface(const HandProfile& profile, std::span<const std::vector<double>> battery, int threads);

}  // namespace uhas
