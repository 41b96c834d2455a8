// First contact of a moving point with a sphere or a deformed profile. Angles run from open toward closed.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "uhas/base/vector3.hpp"
#include "uhas/kinematics/joint_travel.hpp"

namespace uhas {

/// The circle of a point about a joint's axis: p(t) = center + u cos t + v sin t, t = 0 at joint value 0.
template <class Real>
struct Circle {
  Vector3<Real> center, u, v;

  /// @param axis    unit axis, @param origin a point on it, @param p the point at joint value 0, all in one frame
  static Circle about(Vector3<Real> axis, Vector3<Real> origin, Vector3<Real> p) {
    const Vector3<Real> center = origin + dot(p - origin, axis) * axis;
    return {center, p - center, cross(axis, p - center)};
  }
  Vector3<Real> at(Real t) const { return center + std::cos(t) * u + std::sin(t) * v; }
};

/// Where nothing is met, a joint leaves open only for a gap smaller by more than this (radii): a point on the joint's
/// axis moves by rounding alone.
template <class Real>
inline constexpr Real kLeastGain = Real(1e-4);

/// Joint value at which the circle first meets the sphere of radius 1 about the origin on the way from open to closed;
/// a point inside at open is turned outward, toward the opposite end. Without a meeting the value of least | |p| - 1 |
/// on the way. Both have closed forms (docs/method.md#wrap).
template <class Real>
Real first_contact_with_sphere(const Circle<Real>& circle, const JointTravel<Real>& travel) {
  constexpr Real two_pi = 2 * std::numbers::pi_v<Real>;

  // |p(t)|^2 = K + A cos t + B sin t = K + amplitude cos(t - phase)
  const Real K = dot(circle.center, circle.center) + dot(circle.u, circle.u);
  const Real A = 2 * dot(circle.center, circle.u), B = 2 * dot(circle.center, circle.v);
  const Real amplitude = std::hypot(A, B), phase = std::atan2(B, A);
  const auto squared_radius = [&](Real t) { return K + A * std::cos(t) + B * std::sin(t); };

  // the way: from outside the joint closes, from inside it opens further
  const Real end = squared_radius(travel.open) >= Real(1) ? travel.closed : travel.opposite;
  const Real sign = end >= travel.open ? Real(1) : Real(-1);
  const Real length = std::abs(end - travel.open);
  const auto way_to = [&](Real t) {  // distance from open to the next angle equivalent to t, in [0, 2 pi)
    const Real way = std::fmod(sign * (t - travel.open), two_pi);
    return way < Real(0) ? way + two_pi : way;
  };

  // the first of the two angles where |p(t)|^2 = 1, if the way reaches it
  if (amplitude > Real(0) && std::abs(Real(1) - K) <= amplitude) {
    const Real half = std::acos((Real(1) - K) / amplitude);
    // a start on the sphere up to rounding may see its own root a full turn away
    constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
    Real way = two_pi;
    for (Real root : {phase - half, phase + half}) {
      const Real candidate = way_to(root);
      way = std::min(way, candidate > two_pi - rounding ? Real(0) : candidate);
    }
    if (way <= length) return travel.open + sign * way;
  }

  // no contact: of the end and the two extrema on the way the one nearest to the sphere, if that is a gain
  const auto gap = [&](Real t) { return std::abs(std::sqrt(std::max(squared_radius(t), Real(0))) - Real(1)); };
  Real best = end;
  for (Real extremum : {phase, phase + std::numbers::pi_v<Real>}) {
    const Real way = way_to(extremum), t = travel.open + sign * way;
    if (way <= length && gap(t) < gap(best)) best = t;
  }
  return gap(best) < gap(travel.open) - kLeastGain<Real> ? best : travel.open;
}

/// The same for any path and any surface: `gap(t)` is the signed distance of the point from the surface, positive
/// outside. A fixed number of evaluations: the way is scanned for the first change of sign, which is then halved down.
template <class Real, class Gap>
Real first_contact_by_scan(const Gap& gap, const JointTravel<Real>& travel) {
  constexpr int scan_steps = 48, halvings = std::numeric_limits<Real>::digits;

  // the way: from outside the joint closes, from inside it opens further
  const Real gap_open = gap(travel.open);
  const Real end = gap_open >= Real(0) ? travel.closed : travel.opposite;
  const auto at = [&](int k) { return travel.open + (end - travel.open) * Real(k) / Real(scan_steps); };

  // step by step to the first change of sign, which is halved down; the least gap is kept in case there is none
  Real previous = gap_open, least = std::abs(gap_open);
  int least_step = 0;
  for (int k = 1; k <= scan_steps; ++k) {
    const Real current = gap(at(k));
    if ((previous >= Real(0)) != (current >= Real(0))) {
      Real a = at(k - 1), b = at(k);
      for (int i = 0; i < halvings; ++i) {
        const Real middle = (a + b) / 2;
        ((gap(middle) >= Real(0)) == (previous >= Real(0)) ? a : b) = middle;
      }
      return (a + b) / 2;
    }
    if (std::abs(current) < least) least = std::abs(current), least_step = k;
    previous = current;
  }

  // no contact: thirds narrow the interval about the least gap; it counts if it is a gain
  Real a = at(std::max(least_step - 1, 0)), b = at(std::min(least_step + 1, scan_steps));
  for (int i = 0; i < halvings; ++i) {
    const Real c = a + (b - a) / 3, d = b - (b - a) / 3;
    if (std::abs(gap(c)) <= std::abs(gap(d)))
      b = d;
    else
      a = c;
  }
  const Real best = (a + b) / 2;
  return std::abs(gap(best)) < std::abs(gap_open) - kLeastGain<Real> ? best : travel.open;
}

}  // namespace uhas
