// Numbers that carry derivatives along (forward mode): a kernel that runs on them differentiates itself, exactly. Where a
// number is held at a bound, or one of two is chosen, the derivative is that of what was chosen.
#pragma once

#include <array>

#include "uhas/runtime/lanes/lane_math.hpp"

namespace uhas {

/// A value and its derivatives with respect to N inputs.
template <class Real, int N>
struct Dual {
  Real value;
  std::array<Real, N> slope;

  Dual() = default;  // not set, like a plain number
  constexpr Dual(Real constant) : value(constant), slope{} {}
  constexpr Dual(Real v, const std::array<Real, N>& s) : value(v), slope(s) {}

  /// The input number `input`, of which the derivatives are taken.
  static constexpr Dual input(Real value, int input) {
    Dual a(value);
    a.slope[input] = 1;
    return a;
  }

  friend constexpr Dual operator+(const Dual& a, const Dual& b) { return a.with(a.value + b.value, 1, b, 1); }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) { return a.with(a.value - b.value, 1, b, -1); }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return a.with(a.value * b.value, b.value, b, a.value);
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const Real quotient = a.value / b.value;
    return a.with(quotient, 1 / b.value, b, -quotient / b.value);
  }
  friend constexpr Dual operator-(const Dual& a) { return Dual(0) - a; }
  constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
  constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend constexpr bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend constexpr bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend constexpr bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  /// `result`, a function whose derivative is `factor` here and `other` in `b`.
  constexpr Dual with(Real result, Real factor, const Dual& b, Real other) const {
    Dual a(result);
    for (int i = 0; i < N; ++i) a.slope[i] = factor * slope[i] + other * b.slope[i];
    return a;
  }
  constexpr Dual with(Real result, Real factor) const {
    Dual a(result);
    for (int i = 0; i < N; ++i) a.slope[i] = factor * slope[i];
    return a;
  }
};

/// One hand a number, as a plain number is.
template <class R, int N>
struct LaneTraits<Dual<R, N>> {
  using Real = R;
  using Mask = bool;
  static constexpr int width = 1;
};

template <class Real, int N>
Real lane(const Dual<Real, N>& a, int) {
  return a.value;
}
template <class Real, int N>
void set_lane(Dual<Real, N>& a, int, Real constant) {
  a = constant;
}

template <class Real, int N>
Dual<Real, N> sqrt(const Dual<Real, N>& a) {
  const Real root = sqrt(a.value);
  return a.with(root, Real(0.5) / root);
}

template <class Real, int N>
SinCos<Dual<Real, N>> sincos(Dual<Real, N> x) {
  const SinCos<Real> at = sincos(x.value);
  return {.sine = x.with(at.sine, at.cosine), .cosine = x.with(at.cosine, -at.sine)};
}

template <class Real, int N>
Dual<Real, N> atan2(Dual<Real, N> y, Dual<Real, N> x) {
  const Real squared = x.value * x.value + y.value * y.value;
  return y.with(atan2(y.value, x.value), x.value / squared, x, -y.value / squared);
}

}  // namespace uhas
