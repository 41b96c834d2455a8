// A finger of several hands, of which some wait until there is one for each lane.
#pragma once

#include <algorithm>
#include <array>

#include "uhas/runtime/cascade/plane_deformation.hpp"
#include "uhas/runtime/lanes/lanes.hpp"

namespace uhas {

/// What an action says to the finger, a hand a lane, and where its joint values go.
template <class Num>
struct FingerRows {
  using Real = LaneReal<Num>;
  static constexpr int width = LaneTraits<Num>::width;

  int count = 0;  ///< lanes that hold a hand
  Num delta_theta;
  std::array<Num, kMaxDrivingVectors> delta_r, phi;  ///< [V]
  std::array<Real*, width> q;                        ///< [count] joint values of the hand, [joint]

  /// Takes a hand that waits in `from` over.
  void push(const FingerRows& from, int l, int vectors) noexcept {
    // lanes that hold no hand yet repeat the first one
    const auto take = [&](Num& to, const Num& numbers) {
      if (count == 0)
        to = Num(lane(numbers, l));
      else
        set_lane(to, count, lane(numbers, l));
    };
    take(delta_theta, from.delta_theta);
    for (int j = 0; j < vectors; ++j) take(delta_r[j], from.delta_r[j]), take(phi[j], from.phi[j]);
    q[count++] = from.q[l];
  }
};

}  // namespace uhas
