#include "uhas/evaluation/least_squares/driving_plane.hpp"

#include <algorithm>
#include <numbers>

namespace uhas {
namespace {

constexpr double kStep = std::numbers::pi / (ActionSpace::kVectors + 1);  // between driving vectors

}  // namespace

double DrivingPlane::at(double phi) const {
  if (phi <= kStep) return delta_r[0] * phi / kStep;
  return delta_r[0] + (delta_r[1] - delta_r[0]) * std::min(phi - kStep, kStep) / kStep;
}

double DrivingPlane::open_share(double phi) const {
  const double u = std::clamp((1 + at(std::max(phi, kStep))) / 0.5, 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

DrivingPlane driving_plane(const ProfileFinger& finger, const ActionSpace& space, std::span<const double> action) {
  DrivingPlane plane;
  const double slots = static_cast<double>(std::ranges::count(finger.slots, true));
  for (int slot = 0; slot < kSlotCount; ++slot) {
    if (!finger.slots[slot]) continue;
    plane.delta_theta += std::clamp(action[slot], space.lower[slot], space.upper[slot]) / slots;
    for (int j = 0; j < ActionSpace::kVectors; ++j)
      plane.delta_r[j] += std::clamp(action[ActionSpace::radial(slot, j)], -kRadialBound, kRadialBound) / slots;
  }
  return plane;
}

}  // namespace uhas
