// Numbers that carry derivatives along (forward mode): a kernel that runs on them differentiates itself, exactly. Where a
// number is held at a bound, or one of two is chosen, the derivative is that of what was chosen.
#pragma once

#include <array>

#include "uhas/runtime/lanes/lane_math.hpp"

namespace uhas {

/// A value and its derivatives with respect to up to `kInputs` inputs, in the 128 bits that every processor has.
template <class Real>
struct Dual {
  static constexpr int kInputs = 4;
  typedef Real Slopes __attribute__((vector_size(16)));
  static constexpr int kWidth = 16 / sizeof(Real), kVectors = kInputs / kWidth;

  Real value;
  Slopes slopes[kVectors];

  Dual() = default;  // not set, like a plain number
  Dual(Real constant) : value(constant), slopes{} {}

  /// The input number `input`, of which the derivatives are taken.
  static Dual input(Real value, int input) {
    Dual a(value);
    a.slopes[input / kWidth][input % kWidth] = 1;
    return a;
  }
  Real slope(int input) const { return slopes[input / kWidth][input % kWidth]; }

  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual sum;
    sum.value = a.value + b.value;
    for (int i = 0; i < kVectors; ++i) sum.slopes[i] = a.slopes[i] + b.slopes[i];
    return sum;
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    Dual difference;
    difference.value = a.value - b.value;
    for (int i = 0; i < kVectors; ++i) difference.slopes[i] = a.slopes[i] - b.slopes[i];
    return difference;
  }
  friend Dual operator*(const Dual& a, const Dual& b) { return a.with(a.value * b.value, b.value, b, a.value); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Real quotient = a.value / b.value;
    return a.with(quotient, 1 / b.value, b, -quotient / b.value);
  }
  friend Dual operator-(const Dual& a) { return Dual(0) - a; }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend constexpr bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend constexpr bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend constexpr bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  /// `result`, a function whose derivative is `factor` here and `other` in `b`.
  Dual with(Real result, Real factor, const Dual& b, Real other) const {
    Dual a;
    a.value = result;
    for (int i = 0; i < kVectors; ++i) a.slopes[i] = factor * slopes[i] + other * b.slopes[i];
    return a;
  }
  Dual with(Real result, Real factor) const {
    Dual a;
    a.value = result;
    for (int i = 0; i < kVectors; ++i) a.slopes[i] = factor * slopes[i];
    return a;
  }
};

/// One hand a number, as a plain number is.
template <class R>
struct LaneTraits<Dual<R>> {
  using Real = R;
  using Mask = bool;
  static constexpr int width = 1;
};

template <class Real>
Real lane(const Dual<Real>& a, int) {
  return a.value;
}
template <class Real>
void set_lane(Dual<Real>& a, int, Real constant) {
  a = constant;
}

template <class Real>
Dual<Real> sqrt(const Dual<Real>& a) {
  const Real root = sqrt(a.value);
  return a.with(root, Real(0.5) / root);
}

template <class Real>
SinCos<Dual<Real>> sincos(Dual<Real> x) {
  const SinCos<Real> at = sincos(x.value);
  return {.sine = x.with(at.sine, at.cosine), .cosine = x.with(at.cosine, -at.sine)};
}

template <class Real>
Dual<Real> atan2(Dual<Real> y, Dual<Real> x) {
  const Real squared = x.value * x.value + y.value * y.value;
  return y.with(atan2(y.value, x.value), x.value / squared, x, -y.value / squared);
}

}  // namespace uhas
