// From an action's numbers to the deformation of each finger's plane: denormalise, clamp, average shared slots (design 2).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/runtime/action.hpp"

namespace uhas {

/// Polar angle of driving vector `j` of `vectors` unless a call places it.
template <class Real>
Real default_driving_angle(int vectors, int j) {
  return std::numbers::pi_v<Real> * Real(j + 1) / Real(vectors + 1);
}

template <class Real>
class ActionDecoder {
 public:
  explicit ActionDecoder(const HandProfile& profile) {
    for (const ProfileFinger& finger : profile.fingers) {
      Owner owner{.slots = finger.slots, .lower = 0, .upper = 0};
      if (finger.lateral_table >= 0) {
        owner.lower = static_cast<Real>(profile.lateral_tables[finger.lateral_table].delta_theta_lower);
        owner.upper = static_cast<Real>(profile.lateral_tables[finger.lateral_table].delta_theta_upper);
      }
      owners_.push_back(owner);
    }
  }

  /// Writes one deformation a finger into `planes`; untouched unless the status is ok.
  Status decode(const Action<Real>& action, std::span<PlaneDeformation<Real>> planes) const noexcept {
    const int vectors = (static_cast<int>(action.values.size()) - kSlotCount) / kSlotCount;
    if (vectors < 1 || vectors > kMaxDrivingVectors || action.values.size() != std::size_t(kSlotCount * (1 + vectors)))
      return Status::wrong_size;
    for (Real value : action.values)
      if (!std::isfinite(value)) return Status::non_finite_input;
    const std::size_t angles = action.driving_vectors_phi.size();
    if (angles != 0 && angles != std::size_t(vectors) && angles != std::size_t(kSlotCount * vectors)) return Status::wrong_size;
    if (!angles_increase(action.driving_vectors_phi, vectors)) return Status::invalid_driving_vectors;

    for (std::size_t f = 0; f < owners_.size(); ++f) {
      const Owner& owner = owners_[f];
      PlaneDeformation<Real> plane;
      plane.vectors = vectors;
      plane.default_angles = angles == 0;
      int shared = 0;
      for (int slot = 0; slot < kSlotCount; ++slot) {
        if (!owner.slots[slot]) continue;
        ++shared;
        plane.delta_theta += bounded(action.values[slot], owner.lower, owner.upper, action.normalized);
        for (int j = 0; j < vectors; ++j) {
          constexpr Real bound = Real(kRadialBound);
          plane.delta_r[j] += bounded(action.values[kSlotCount + vectors * slot + j], -bound, bound, action.normalized);
          plane.phi[j] += driving_angle(action.driving_vectors_phi, vectors, slot, j);
        }
      }
      plane.delta_theta /= Real(shared);
      for (int j = 0; j < vectors; ++j) plane.delta_r[j] /= Real(shared), plane.phi[j] /= Real(shared);
      planes[f] = plane;
    }
    return Status::ok;
  }

 private:
  struct Owner {
    std::array<bool, kSlotCount> slots;
    Real lower, upper;  // bounds of delta theta
  };

  static Real bounded(Real value, Real lower, Real upper, bool normalized) noexcept {
    if (normalized) value *= value < Real(0) ? -lower : upper;
    return std::clamp(value, lower, upper);
  }

  static Real driving_angle(std::span<const Real> angles, int vectors, int slot, int j) noexcept {
    if (angles.empty()) return default_driving_angle<Real>(vectors, j);
    return angles.size() == std::size_t(vectors) ? angles[j] : angles[vectors * slot + j];
  }

  static bool angles_increase(std::span<const Real> angles, int vectors) noexcept {
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const Real before = i % vectors == 0 ? Real(0) : angles[i - 1];
      if (!(angles[i] > before) || !(angles[i] < std::numbers::pi_v<Real>)) return false;
    }
    return true;
  }

  std::vector<Owner> owners_;
};

template <class Real>
Real PlaneDeformation<Real>::radial(Real at) const {
  Real before_phi = 0, before = 0;  // the palm pole is anchored
  for (int j = 0; j < vectors; ++j) {
    if (at < phi[j]) return before + (delta_r[j] - before) * (at - before_phi) / (phi[j] - before_phi);
    before_phi = phi[j], before = delta_r[j];
  }
  return before;
}

}  // namespace uhas
