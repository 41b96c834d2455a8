// The deformation of one finger's driving plane (docs/method.md#driving-planes): what an action says to a finger,
// bounded, slots averaged.
#pragma once

#include <array>
#include <numbers>
#include <span>
#include <type_traits>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/lanes/lanes.hpp"

namespace uhas {

/// Where a joint looks at the displacement to lead its fit (lead.hpp): at the angles of two driving vectors.
inline constexpr int kLeadInputs = 2;
constexpr std::array<double, kLeadInputs> kLeadAngles{std::numbers::pi / 3, 2 * std::numbers::pi / 3};

/// What a lead takes of a displacement: all of a small one, ever less of a larger one, of which first order knows
/// little, and no more from `bound` on, smoothly.
template <class Num>
Num lead_input(Num delta_r) {
  using Real = LaneReal<Num>;
  constexpr Real bound{0.6f};  // radii; 0.45 to 0.8 fit alike
  const Num d = clamp(delta_r, Num(-bound), Num(bound));
  return d - d * d * d * Num(1 / (3 * bound * bound));
}

/// Calls `use` with the number of driving vectors as a constant, so that loops over them unroll.
template <class Use>
void with_constant(int vectors, const Use& use) {
  static_assert(kMaxDrivingVectors == 4);
  switch (vectors) {
    case 1: return use(std::integral_constant<int, 1>{});
    case 2: return use(std::integral_constant<int, 2>{});
    case 3: return use(std::integral_constant<int, 3>{});
    default: return use(std::integral_constant<int, 4>{});
  }
}

/// A displacement over polar angles: linear between driving vectors and constant beyond the last one; before the first
/// one linear from 0 at the palm pole, or constant too. Nothing is set by default: a solve makes many of these.
template <class Num>
struct RadialProfile {
  int vectors;                                  ///< V
  std::array<Num, kMaxDrivingVectors> phi;      ///< [V] polar angles of the driving vectors, increasing
  std::array<Num, kMaxDrivingVectors> delta_r;  ///< [V] displacements there, radii
  std::array<Num, kMaxDrivingVectors> slope;  ///< [V] radii a rad, on the way from vector j - 1 (first: the pole) to j

  /// The displacement at a polar angle, and at the greater of that angle and the first driving vector's.
  struct At {
    Num delta_r, past_first;
  };

  At at(Num angle) const { return at(angle, vectors); }

  /// Summed from beyond the last vector, so that equal displacements come out exactly equal.
  /// @param count  V, or a constant of that value
  template <class Count>
  At at(Num angle, Count count) const {
    // from the last vector's displacement back along each slope, as far as the angle lies before its end
    Num past_first = delta_r[count - 1];
    for (int j = count - 1; j > 0; --j) past_first -= slope[j] * (phi[j] - clamp(angle, phi[j - 1], phi[j]));
    return {past_first - slope[0] * (phi[0] - min(angle, phi[0])), past_first};
  }

  /// Slope past driving vector `j`.
  Num slope_past(int j) const { return j + 1 < vectors ? slope[j + 1] : Num(0); }
};

template <class Num>
struct PlaneDeformation : RadialProfile<Num> {
  Num delta_theta{};                    ///< rad, canonical
  bool common_angles = true;            ///< `phi` are the same in every lane
  Num lowest{};                         ///< least displacement of a vector
  Num steepest{};                       ///< greatest |slope|
  std::array<Num, kLeadInputs> lead{};  ///< `lead_input` at `kLeadAngles`

  /// All that follows from vectors, angles and displacements.
  /// @param held_toward_pole  constant before the first vector
  /// @param default_angles    `phi` are pi j / (V + 1)
  void complete(bool held_toward_pole, bool default_angles) {
    // slopes between the vectors, the first one from the anchored pole
    this->slope[0] = held_toward_pole ? Num(0) : this->delta_r[0] / this->phi[0];
    lowest = this->delta_r[0];
    steepest = abs(this->slope[0]);
    for (int j = 1; j < this->vectors; ++j) {
      this->slope[j] = (this->delta_r[j] - this->delta_r[j - 1]) / (this->phi[j] - this->phi[j - 1]);
      lowest = min(lowest, this->delta_r[j]);
      steepest = max(steepest, abs(this->slope[j]));
    }
    // what leads read; two default vectors stand where they look
    if (default_angles && this->vectors == kLeadInputs) {
      for (int u = 0; u < kLeadInputs; ++u) lead[u] = lead_input(this->delta_r[u]);
    } else {
      for (int u = 0; u < kLeadInputs; ++u) lead[u] = lead_input(this->at(Num(LaneReal<Num>(kLeadAngles[u]))).delta_r);
    }
  }
};

/// Displacement at a polar angle when that of driving vector `j` of those at `phi` is 1 and the others are 0.
inline double displacement_share(double angle, std::span<const double> phi, int j, bool held_toward_pole) {
  PlaneDeformation<double> unit{};
  unit.vectors = static_cast<int>(phi.size());
  for (int k = 0; k < unit.vectors; ++k) unit.phi[k] = phi[k];
  unit.delta_r[j] = 1;
  unit.complete(held_toward_pole, false);
  return unit.at(angle).delta_r;
}

}  // namespace uhas
