// The deformation of one finger's driving plane: what an action says to a finger, bounded, slots averaged.
#pragma once

#include <array>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/lanes_detail.hpp"

namespace uhas {

template <class Num>
struct PlaneDeformation {
  Num delta_theta{};                              ///< rad, canonical
  int vectors = 2;                                ///< V
  bool common_angles = true;                      ///< `phi` are the same in every lane
  std::array<Num, kMaxDrivingVectors> phi{};      ///< [V] polar angles of the driving vectors, increasing
  std::array<Num, kMaxDrivingVectors> delta_r{};  ///< [V] displacements, radii

  // what follows from these
  std::array<Num, kMaxDrivingVectors> slope{};  ///< [V] radii a rad, on the way from vector j - 1 (first: the pole) to j
  Num lowest{}, steepest{};                     ///< least displacement of a vector; greatest |slope|

  /// To be called when the numbers above have been set.
  void find_slopes() {
    lowest = delta_r[0];
    steepest = Num(0);
    for (int j = 0; j < vectors; ++j) {
      slope[j] = j == 0 ? delta_r[0] / phi[0] : (delta_r[j] - delta_r[j - 1]) / (phi[j] - phi[j - 1]);
      lowest = min(lowest, delta_r[j]);
      steepest = max(steepest, abs(slope[j]));
    }
  }

  /// The displacement at a polar angle, and at the greater of that angle and the first driving vector's.
  struct Radial {
    Num delta_r, past_first;
  };

  /// 0 at the palm pole, linear between driving vectors, constant beyond the last one. Summed from there, so that equal
  /// displacements come out exactly equal.
  template <class At>
  Radial radial(At at) const {
    const Num angle(at);
    Num past_first = delta_r[vectors - 1];
    for (int j = vectors - 1; j > 0; --j) past_first -= slope[j] * (phi[j] - clamp(angle, phi[j - 1], phi[j]));
    return {past_first - slope[0] * (phi[0] - min(angle, phi[0])), past_first};
  }

  /// Slope past driving vector `j`.
  Num slope_past(int j) const { return j + 1 < vectors ? slope[j + 1] : Num(0); }
};

}  // namespace uhas
