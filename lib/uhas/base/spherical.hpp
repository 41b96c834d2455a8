// Spherical coordinates of the sphere frame S, and angles on the circle.
// azimuth theta = atan2(y, x) in (-pi, pi]; polar angle phi = acos(-z / |p|) in [0, pi], 0 at the palm pole
// (design: z of S is the OUTWARD palm normal, and the palm is the north pole).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/base/vector3.hpp"

namespace uhas {

template <class Real>
struct Spherical {
  Real azimuth{}, polar{}, radius{};
};

/// `angle` brought to (-pi, pi].
template <class Real>
Real wrap_angle(Real angle) {
  constexpr Real pi = std::numbers::pi_v<Real>;
  if (angle > -pi && angle <= pi) return angle;
  const Real wrapped = angle - Real(2) * pi * std::ceil((angle - pi) / (Real(2) * pi));
  return wrapped <= -pi || wrapped > pi ? pi : wrapped;  // rounding may step over either end
}

/// Spherical coordinates of `p` in S. The centre has azimuth 0 and polar angle pi / 2.
template <class Real>
Spherical<Real> to_spherical(Vector3<Real> p) {
  const Real radius = norm(p);
  if (!(radius > Real(0))) return {Real(0), std::numbers::pi_v<Real> / 2, Real(0)};
  return {std::atan2(p.y, p.x), std::atan2(std::hypot(p.x, p.y), -p.z), radius};
}

/// The point of S with spherical coordinates `s`.
template <class Real>
Vector3<Real> from_spherical(Spherical<Real> s) {
  const Real sin_polar = std::sin(s.polar);
  return s.radius * Vector3<Real>{sin_polar * std::cos(s.azimuth), sin_polar * std::sin(s.azimuth), -std::cos(s.polar)};
}

}  // namespace uhas
