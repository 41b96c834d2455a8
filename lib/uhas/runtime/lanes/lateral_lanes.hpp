// Look-up in a lateral table for several hands at once.
#pragma once

#include "uhas/runtime/cascade/solver_model.hpp"
#include "uhas/runtime/lanes/lanes.hpp"

namespace uhas {

/// Joint values at `delta_theta` (rad): what `look_up_lateral` says of each lane, without branches.
template <class Num>
Num look_up_lateral(const SolverLateral<LaneReal<Num>>& table, Num delta_theta) noexcept {
  using Real = LaneReal<Num>;
  const int m = static_cast<int>(table.inverse_q.size() / 2);
  const MaskOf<Num> negative = delta_theta < Num(0);
  // steps away from the middle, and the step in which that is; a side of no width has none
  const Num bound = select(negative, Num(table.lower), Num(table.upper));
  const MaskOf<Num> flat = bound == Num(0);
  const Num steps = Num(Real(m));
  const Num position = select(flat, Num(0), delta_theta / select(flat, Num(1), bound) * steps);
  const Num inside = min(position, Num(Real(m - 1)));
  Num step, near, far;
  for (int l = 0; l < LaneTraits<Num>::width; ++l) {
    const int whole = static_cast<int>(lane(inside, l));
    const int here = lane(negative, l) ? m - whole : m + whole;
    set_lane(step, l, Real(whole));
    set_lane(near, l, table.inverse_q[here]);
    set_lane(far, l, table.inverse_q[lane(negative, l) ? here - 1 : here + 1]);
  }
  const Num between = clamp(near + (position - step) * (far - near), min(near, far), max(near, far));
  return select(position < steps, select(position == Num(0), near, between), far);
}

}  // namespace uhas
