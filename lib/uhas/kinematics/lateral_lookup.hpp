// Look-up in a lateral table: a joint value from delta theta in constant time, and the way back.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace uhas {

/// Joint value at `delta_theta`, which is held within [lower, upper]. Zero returns `inverse_q[m]`, the neutral value,
/// and the bounds return the ends, bit for bit; no value leaves the range of the table, not by rounding either.
/// @param inverse_q  [2 m + 1] joint values: m equal steps from `lower` <= 0 to 0, m equal steps from 0 to `upper` >= 0
template <class Real>
Real look_up_lateral(std::span<const Real> inverse_q, Real lower, Real upper, Real delta_theta) {
  const int m = static_cast<int>(inverse_q.size() / 2);
  const Real bound = delta_theta < Real(0) ? lower : upper;
  if (delta_theta == Real(0) || bound == Real(0)) return inverse_q[m];
  const int side = delta_theta < Real(0) ? -1 : 1;
  const Real position = delta_theta / bound * Real(m);  // steps away from the middle
  if (!(position < Real(m))) return inverse_q[m + side * m];
  const int step = static_cast<int>(position);
  const Real near = inverse_q[m + side * step], far = inverse_q[m + side * (step + 1)];
  return std::clamp(near + (position - Real(step)) * (far - near), std::min(near, far), std::max(near, far));
}

/// The way back: the delta theta at which `look_up_lateral` gives `q`, which is held within the table's range.
template <class Real>
Real look_up_delta_theta(std::span<const Real> inverse_q, Real lower, Real upper, Real q) {
  const int m = static_cast<int>(inverse_q.size() / 2);
  const Real sign = inverse_q.back() < inverse_q.front() ? Real(-1) : Real(1);
  const Real held = std::clamp(sign * q, sign * inverse_q.front(), sign * inverse_q.back());
  const auto above =
      std::partition_point(inverse_q.begin() + 1, inverse_q.end() - 1, [&](Real v) { return sign * v < held; });
  const Real before = sign * *(above - 1), after = sign * *above;
  const Real within = after > before ? (held - before) / (after - before) : Real(0);
  const Real position = Real(above - 1 - inverse_q.begin()) + within - Real(m);  // steps away from the middle
  return position / Real(m) * (position < Real(0) ? -lower : upper);
}

}  // namespace uhas
