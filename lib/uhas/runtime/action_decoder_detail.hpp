// From an action's numbers to the deformation of each finger's plane: denormalise, clamp, average shared slots (design 2).
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/runtime/action.hpp"
#include "uhas/runtime/plane_deformation_detail.hpp"

namespace uhas {

/// The numbers of an action that has passed `ActionDecoder::check`, one action a lane.
template <class Num>
struct ActionNumbers {
  const Num* values;       ///< [5 + 5 V]
  const Num* phi;          ///< [angles]
  int vectors;             ///< V
  int angles = 0;          ///< 0: default driving angles; V or 5 V
  bool common_phi = true;  ///< `phi` are the same in every lane
  bool normalized = false;
};

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
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors)
      for (int j = 0; j < vectors; ++j)
        default_phi_[vectors - 1][j] = std::numbers::pi_v<Real> * Real(j + 1) / Real(vectors + 1);
  }

  /// Whether an action of `size` numbers can be decoded; the number of its driving vectors, 0 if not.
  static int vectors_of(std::size_t size) noexcept {
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors)
      if (size == std::size_t(kSlotCount * (1 + vectors))) return vectors;
    return 0;
  }

  /// What solving `action` would be refused for.
  static Status check(const Action<Real>& action) noexcept {
    const int vectors = vectors_of(action.values.size());
    if (vectors == 0) return Status::wrong_size;
    for (Real value : action.values)
      if (!std::isfinite(value)) return Status::non_finite_input;
    return check_angles(action.driving_vectors_phi, vectors);
  }

  /// The same for driving angles alone.
  static Status check_angles(std::span<const Real> phi, int vectors) noexcept {
    if (!phi.empty() && phi.size() != std::size_t(vectors) && phi.size() != std::size_t(kSlotCount * vectors))
      return Status::wrong_size;
    for (std::size_t i = 0; i < phi.size(); ++i) {
      const Real before = i % vectors == 0 ? Real(0) : phi[i - 1];
      if (!(phi[i] > before) || !(phi[i] < std::numbers::pi_v<Real>)) return Status::invalid_driving_vectors;
    }
    return Status::ok;
  }

  /// One deformation a finger. `planes`: [finger].
  template <class Num>
  void decode(const ActionNumbers<Num>& action, PlaneDeformation<Num>* planes) const noexcept {
    const int vectors = action.vectors;
    for (std::size_t f = 0; f < owners_.size(); ++f) {
      const Owner& owner = owners_[f];
      PlaneDeformation<Num>& plane = planes[f];
      plane.vectors = vectors;
      plane.delta_theta = Num(0);
      for (int j = 0; j < vectors; ++j) plane.delta_r[j] = plane.phi[j] = Num(0);
      plane.common_angles = action.angles == 0 || action.common_phi;
      int shared = 0;
      for (int slot = 0; slot < kSlotCount; ++slot) {
        if (!owner.slots[slot]) continue;
        ++shared;
        plane.delta_theta += bounded(action.values[slot], owner.lower, owner.upper, action.normalized);
        for (int j = 0; j < vectors; ++j) {
          constexpr Real bound = Real(kRadialBound);
          plane.delta_r[j] += bounded(action.values[kSlotCount + vectors * slot + j], -bound, bound, action.normalized);
          if (action.angles != 0) plane.phi[j] += action.phi[(action.angles == vectors ? 0 : vectors * slot) + j];
        }
      }
      const Num share(Real(1) / Real(shared));
      plane.delta_theta *= share;
      for (int j = 0; j < vectors; ++j) {
        plane.delta_r[j] *= share;
        plane.phi[j] = action.angles == 0 ? Num(default_phi_[vectors - 1][j]) : plane.phi[j] * share;
      }
      plane.find_slopes();
    }
  }

 private:
  struct Owner {
    std::array<bool, kSlotCount> slots;
    Real lower, upper;  // bounds of delta theta
  };

  template <class Num>
  static Num bounded(Num value, Real lower, Real upper, bool normalized) noexcept {
    if (normalized) value *= select(value < Num(0), Num(-lower), Num(upper));
    return clamp(value, Num(lower), Num(upper));
  }

  std::vector<Owner> owners_;
  std::array<std::array<Real, kMaxDrivingVectors>, kMaxDrivingVectors> default_phi_{};  // [V - 1][j]
};

}  // namespace uhas
