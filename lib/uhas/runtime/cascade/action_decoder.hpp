// From an action's numbers to the deformation of each finger's plane: denormalise, clamp, average shared slots
// (docs/conventions.md#the-action).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/runtime/action.hpp"
#include "uhas/runtime/cascade/plane_deformation.hpp"

namespace uhas {

/// Radial bounds are at most so far from 0: squares of what follows from them stay finite in float.
inline constexpr double kMostRadialBound = 1e6;

/// Throws Error: invalid_option for numbers of the convention out of range.
void check_convention(const ActionConvention& convention);

/// The numbers of an action that has passed `ActionDecoder::check`, one action a lane.
template <class Num>
struct ActionNumbers {
  const Num* values;       ///< [5 + 5 V]
  const Num* phi;          ///< [angles]
  int vectors;             ///< V
  int angles = 0;          ///< 0: default driving angles; V or 5 V
  bool common_phi = true;  ///< `phi` are the same in every lane
  bool normalized = false;
  const Num* azimuth_offsets = nullptr;  ///< [5]; null: none
  const Num* radial_bounds = nullptr;    ///< [2] lower, upper; null: the convention's
};

/// Null for no numbers at all.
template <class Real>
const Real* data_or_null(std::span<const Real> numbers) noexcept {
  return numbers.empty() ? nullptr : numbers.data();
}

template <class Real>
class ActionDecoder {
 public:
  /// @param profile, convention  that `validate_profile` and `check_convention` let pass
  explicit ActionDecoder(const HandProfile& profile, const ActionConvention& convention = {});

  /// Whether an action of `size` numbers can be decoded; the number of its driving vectors, 0 if not.
  static int vectors_of(std::size_t size) noexcept;

  /// What solving `action` would be refused for.
  static Status check(const Action<Real>& action) noexcept;

  /// The same for azimuth offsets, for radial bounds and for driving angles alone.
  static Status check_offsets(std::span<const Real> offsets) noexcept;
  static Status check_bounds(std::span<const Real> bounds) noexcept;
  static Status check_angles(std::span<const Real> phi, int vectors) noexcept;

  /// The numbers of an action that has passed `check`.
  static ActionNumbers<Real> numbers_of(const Action<Real>& action) noexcept {
    return {.values = action.values.data(),
            .phi = action.driving_vectors_phi.data(),
            .vectors = vectors_of(action.values.size()),
            .angles = static_cast<int>(action.driving_vectors_phi.size()),
            .normalized = action.normalized,
            .azimuth_offsets = data_or_null(action.azimuth_offsets),
            .radial_bounds = data_or_null(action.radial_bounds)};
  }

  /// Calls `use(number, input, slope)` for each number of the action that `finger` reads: input 0 = delta theta, 1 + j = the
  /// displacement of driving vector j; the slope of that input, as `decode_finger` makes it, against the number.
  template <class Use>
  void each_slope(const ActionNumbers<Real>& action, int finger, const Use& use) const noexcept {
    const Owner& owner = owners_[finger];
    const Real lowest = action.radial_bounds ? action.radial_bounds[0] : Real(convention_.radial_lower);
    const Real highest = action.radial_bounds ? action.radial_bounds[1] : Real(convention_.radial_upper);
    // of a number that is clamped 0, else what a unit of it is scaled to
    const auto slope = [&](Real value, Real lower, Real upper) {
      const Real unit = action.normalized ? (value < Real(0) ? -lower : upper) : Real(1);
      const Real there = value * unit;
      return there < lower || there > upper ? Real(0) : unit * owner.share;
    };
    for (int n = 0; n < owner.slot_count; ++n) {
      const int slot = owner.slots[n];
      const Real sign(Real(convention_.azimuth_sign)), input = sign * action.values[slot];
      const Real turn = bounded(input, owner.lower, owner.upper, action.normalized);
      const Real offset = action.azimuth_offsets ? action.azimuth_offsets[slot] : Real(0);
      const bool offset_clamps = turn + offset < owner.lower || turn + offset > owner.upper;
      use(slot, 0, offset_clamps ? Real(0) : sign * slope(input, owner.lower, owner.upper));
      for (int j = 0; j < action.vectors; ++j) {
        const int number = kSlotCount + action.vectors * slot + j;
        use(number, 1 + j, slope(action.values[number], lowest, highest));
      }
    }
  }

  /// Whether a number of the action is beyond its bounds; an offset may bring one there.
  bool clamps(const ActionNumbers<Real>& action) const noexcept {
    const Real lowest = action.radial_bounds ? action.radial_bounds[0] : Real(convention_.radial_lower);
    const Real highest = action.radial_bounds ? action.radial_bounds[1] : Real(convention_.radial_upper);
    const auto beyond = [](Real value, Real lower, Real upper) { return value < lower || value > upper; };
    for (const Owner& owner : owners_)
      for (int n = 0; n < owner.slot_count; ++n) {
        const int slot = owner.slots[n];
        const Real turn =
            scaled(Real(convention_.azimuth_sign) * action.values[slot], owner.lower, owner.upper, action.normalized);
        const Real offset = action.azimuth_offsets ? action.azimuth_offsets[slot] : Real(0);
        if (beyond(turn, owner.lower, owner.upper)) return true;
        if (beyond(turn + offset, owner.lower, owner.upper)) return true;
        for (int j = 0; j < action.vectors; ++j)
          if (beyond(scaled(action.values[kSlotCount + action.vectors * slot + j], lowest, highest, action.normalized),
                     lowest, highest))
            return true;
      }
    return false;
  }

  /// [V] polar angles of driving vectors that an action does not place, rad.
  std::span<const Real> default_angles(int vectors) const noexcept {
    return {default_phi_[vectors - 1].data(), std::size_t(vectors)};
  }

  /// `PlaneDeformation::lead` of displacements at default driving vectors.
  /// @param delta_r  [V]
  template <class Num>
  Num default_lead(int vectors, int input, const Num* delta_r) const noexcept {
    Num there(0);
    for (int j = 0; j < vectors; ++j) there += Num(lead_shares_[vectors - 1][input][j]) * delta_r[j];
    return lead_input(there);
  }

  /// One deformation a finger. `planes`: [finger].
  template <class Num>
  void decode(const ActionNumbers<Num>& action, PlaneDeformation<Num>* planes) const noexcept {
    for (std::size_t f = 0; f < owners_.size(); ++f) decode_finger(action, static_cast<int>(f), planes[f]);
  }

  template <class Num>
  void decode_finger(const ActionNumbers<Num>& action, int finger, PlaneDeformation<Num>& plane) const noexcept {
    plane.delta_theta = decode_numbers(action, finger, plane.delta_r.data());
    complete(action, finger, plane);
  }

  /// All that follows from a plane's displacements.
  template <class Num>
  void complete(const ActionNumbers<Num>& action, int finger, PlaneDeformation<Num>& plane) const noexcept {
    if (action.angles != 0) decode_angles(action, finger, plane.phi.data());
    complete(action.vectors, action.angles == 0, action.common_phi, plane);
  }

  /// The same, its polar angles set unless they are the default ones.
  template <class Num>
  void complete(int vectors, bool default_angles, bool common_phi, PlaneDeformation<Num>& plane) const noexcept {
    plane.vectors = vectors;
    plane.common_angles = default_angles || common_phi;
    if (default_angles)
      for (int j = 0; j < vectors; ++j) plane.phi[j] = Num(default_phi_[vectors - 1][j]);
    plane.complete(convention_.held_toward_pole, default_angles);
  }

  /// [V] polar angles (rad) of a finger's driving vectors, of an action that places them: the means over its slots.
  template <class Num>
  void decode_angles(const ActionNumbers<Num>& action, int finger, Num* phi) const noexcept {
    const Owner& owner = owners_[finger];
    for (int j = 0; j < action.vectors; ++j) {
      phi[j] = Num(0);
      for (int n = 0; n < owner.slot_count; ++n)
        phi[j] += action.phi[(action.angles == action.vectors ? 0 : action.vectors * owner.slots[n]) + j];
      phi[j] *= Num(owner.share);
    }
  }

  /// delta theta (rad) of a finger, and its displacements (radii): the means over its slots.
  /// @param delta_r  [V] out
  template <class Num>
  Num decode_numbers(const ActionNumbers<Num>& action, int finger, Num* delta_r) const noexcept {
    const Owner& owner = owners_[finger];
    const int vectors = action.vectors;
    // what the convention and the call say of all slots: bounds, the input of the undeformed sphere, the azimuth's sign
    const bool own_bounds = action.radial_bounds != nullptr;
    const Num lowest = own_bounds ? action.radial_bounds[0] : Num(Real(convention_.radial_lower));
    const Num highest = own_bounds ? action.radial_bounds[1] : Num(Real(convention_.radial_upper));
    const Num at_rest(convention_.absolute_radii ? Real(1) : Real(0));
    const Num sign(Real(convention_.azimuth_sign)), lower(owner.lower), upper(owner.upper);

    Num sum(0);
    for (int j = 0; j < vectors; ++j) delta_r[j] = Num(0);
    for (int n = 0; n < owner.slot_count; ++n) {
      const int slot = owner.slots[n];
      // azimuth: bounded, turned on by an offset, bounded again
      Num delta_theta = bounded(sign * action.values[slot], lower, upper, action.normalized);
      if (action.azimuth_offsets != nullptr)
        delta_theta = clamp(delta_theta + action.azimuth_offsets[slot], lower, upper);
      sum += delta_theta;
      // displacements at the driving vectors: bounded, counted from the undeformed sphere
      for (int j = 0; j < vectors; ++j) {
        const Num& input = action.values[kSlotCount + vectors * slot + j];
        delta_r[j] += bounded(input, lowest, highest, action.normalized) - at_rest;
      }
    }
    for (int j = 0; j < vectors; ++j) delta_r[j] *= Num(owner.share);
    return sum * Num(owner.share);
  }

 private:
  struct Owner {
    std::array<int, kSlotCount> slots;  // [slot_count]
    int slot_count;
    Real share;         // of each of them in the mean
    Real lower, upper;  // bounds of delta theta
  };

  template <class Num>
  static Num scaled(Num value, Num lower, Num upper, bool normalized) noexcept {
    return normalized ? value * select(value < Num(0), -lower, upper) : value;
  }
  template <class Num>
  static Num bounded(Num value, Num lower, Num upper, bool normalized) noexcept {
    return clamp(scaled(value, lower, upper, normalized), lower, upper);
  }

  ActionConvention convention_;
  std::vector<Owner> owners_;                                                           // [finger]
  std::array<std::array<Real, kMaxDrivingVectors>, kMaxDrivingVectors> default_phi_{};  // [V - 1][j]
  std::array<std::array<std::array<Real, kMaxDrivingVectors>, kLeadInputs>, kMaxDrivingVectors> lead_shares_{};
};

extern template class ActionDecoder<float>;
extern template class ActionDecoder<double>;

}  // namespace uhas
