// The deformation of a finger's plane, written a second time from docs/conventions.md#the-action and
// docs/method.md#driving-planes alone, for two driving vectors.
#pragma once

#include <array>
#include <span>

#include "uhas/evaluation/action_space.hpp"

namespace uhas {

/// The mean of the finger's slots, the azimuth within the bounds of its table.
struct DrivingPlane {
  double delta_theta = 0;
  std::array<double, ActionSpace::kVectors> delta_r{};

  /// Displacement at a polar angle: 0 at the pole, linear to the first vector at 60°, to the second at
  /// 120°, constant beyond.
  double at(double phi) const;

  /// What is left of a point as its sphere radius falls from 0.5 to 0; never less near the pole than at
  /// the first vector.
  double open_share(double phi) const;
};

DrivingPlane driving_plane(const ProfileFinger& finger, const ActionSpace& space, std::span<const double> action);

}  // namespace uhas
