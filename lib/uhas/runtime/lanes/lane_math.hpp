// Sine, cosine and arc tangent without branches, for Lanes and plain numbers alike. Polynomials: Cephes
// (S. L. Moshier).
//
// Largest errors, held by the unit test against libm in extended precision:
//   sincos  |x| <= 1000 rad                         float 1.3e-7,  double 2.3e-16
//   atan2   every y and x whose squares are finite  float 3e-7,    double 4.5e-16   (rad)
#pragma once

#include <numbers>
#include <type_traits>

#include "uhas/runtime/lanes/lanes.hpp"

namespace uhas {

template <class Num>
struct SinCos {
  Num sine, cosine;
};

/// A whole number n and what turning by n quarters of a circle does to sine and cosine.
template <class Num>
struct QuarterTurns {
  Num count;
  MaskOf<Num> swaps, negates_sine, negates_cosine;
};

/// The nearest whole number to x, ties to even; |x| below 2^22 (float) or 2^51 (double).
template <class Num>
QuarterTurns<Num> quarter_turns(Num x) {
  using Real = LaneReal<Num>;
  // a number so large that its last binary digit is worth 1: the sum's last digits are those of n in two's complement
  const Num large(std::is_same_v<Real, float> ? Real(0x1.8p23) : Real(0x1.8p52));
  const Num sum = x + large;
  const auto n = bits(sum);
  return {.count = sum - large,
          .swaps = nonzero<Num>(n & 1),
          .negates_sine = nonzero<Num>(n & 2),
          .negates_cosine = nonzero<Num>((n + 1) & 2)};
}

/// Horner's rule: c_0 x^(n-1) + ... + c_(n-1).
template <class Num, class... Real>
Num polynomial(Num x, double first, Real... others) {
  Num sum(static_cast<LaneReal<Num>>(first));
  ((sum = sum * x + Num(static_cast<LaneReal<Num>>(others))), ...);
  return sum;
}

/// Sine and cosine of `x` (rad), |x| <= 1000.
template <class Num>
SinCos<Num> sincos(Num x) {
  using Real = LaneReal<Num>;
  constexpr bool is_float = std::is_same_v<Real, float>;
  // x = n pi/2 + r with |r| <= pi/4; pi/2 in three parts, of which n times the first two is exact
  const QuarterTurns<Num> quarters = quarter_turns(x * Num(Real(2 / std::numbers::pi)));
  const Num n = quarters.count;
  Num r = x - n * Num(is_float ? Real(1.5703125) : Real(1.57079632673412561417e+00));
  r = r - n * Num(is_float ? Real(4.837512969970703125e-4) : Real(6.07710050630396597660e-11));
  r = r - n * Num(is_float ? Real(7.5497899548918821616e-8) : Real(2.02226624879595063154e-21));

  const Num z = r * r;
  Num s, c;
  if constexpr (is_float) {
    s = r + r * z * polynomial(z, -1.9515295891e-4, 8.3321608736e-3, -1.6666654611e-1);
    c = Num(1) - Num(Real(0.5)) * z +
        z * z * polynomial(z, 2.443315711809948e-5, -1.388731625493765e-3, 4.166664568298827e-2);
  } else {
    s = r + r * z *
                polynomial(z, 1.58962301576546568060e-10, -2.50507477628578072866e-8, 2.75573136213857245213e-6,
                           -1.98412698295895385996e-4, 8.33333333332211858878e-3, -1.66666666666666307295e-1);
    c = Num(1) - Num(Real(0.5)) * z +
        z * z *
            polynomial(z, -1.13585365213876817300e-11, 2.08757008419747316778e-9, -2.75573141792967388112e-7,
                       2.48015872888517045348e-5, -1.38888888888730564116e-3, 4.16666666666665929218e-2);
  }

  const Num sine = select(quarters.swaps, c, s), cosine = select(quarters.swaps, s, c);
  return {.sine = select(quarters.negates_sine, -sine, sine),
          .cosine = select(quarters.negates_cosine, -cosine, cosine)};
}

/// The angle of (x, y) in [-pi, pi], rad. (0, 0) has the angle 0; the sign of a zero is not looked at.
template <class Num>
Num atan2(Num y, Num x) {
  using Real = LaneReal<Num>;
  const Num ax = abs(x), ay = abs(y), small = min(ax, ay), large = max(ax, ay);
  // small / large = tan(angle); beyond pi/8 by atan(t) = pi/4 + atan((t - 1) / (t + 1))
  const MaskOf<Num> beyond = small > Num(Real(0.41421356237309504880)) * large;
  const Num numerator = select(beyond, small - large, small), denominator = select(beyond, small + large, large);
  const Num t = numerator / select(denominator == Num(0), Num(1), denominator);
  const Num z = t * t;
  Num angle;
  if constexpr (std::is_same_v<Real, float>) {
    angle = t + t * z * polynomial(z, 8.05374449538e-2, -1.38776856032e-1, 1.99777106478e-1, -3.33329491539e-1);
  } else {
    angle = t + t * z *
                    polynomial(z, -8.750608600031904122785e-1, -1.615753718733365076637e1, -7.500855792314704667340e1,
                               -1.228866684490136173410e2, -6.485021904942025371773e1) /
                    polynomial(z, 1.0, 2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
                               4.853903996359136964868e2, 1.945506571482613964425e2);
  }
  constexpr Real pi = std::numbers::pi_v<Real>;
  angle = select(beyond, Num(pi / 4) + angle, angle);
  angle = select(ay > ax, Num(pi / 2) - angle, angle);
  angle = select(x < Num(0), Num(pi) - angle, angle);
  return select(y < Num(0), -angle, angle);
}

}  // namespace uhas
