// The walk along an AffineBundle, from the palm to the tip: each joint is fitted with those before it final and those
// further out at their start. A template over its numbers, like the cascade.
#pragma once

#include <array>
#include <type_traits>

#include "uhas/runtime/cascade/affine_pass.hpp"
#include "uhas/runtime/cascade/moments.hpp"
#include "uhas/runtime/cascade/plane_deformation.hpp"
#include "uhas/runtime/lanes/lane_math.hpp"

namespace uhas {

/// The deformation of a finger's plane, a finger or a hand a lane.
template <class Num>
struct WalkInput {
  std::array<Num, kMaxDrivingVectors> delta_r;  ///< [V] radii
  std::array<Num, kLeadInputs> leads;           ///< `PlaneDeformation::lead`
  Num azimuth;                                  ///< rad about the z of S
  Num lateral;                                  ///< value of the lateral joint, rad; 0 without one
};

/// Reads numbers of a bundle one after the other: a number a lane, or, of a bundle of one finger, one for all lanes.
template <class Num, bool Spread>
class NumberReader {
 public:
  using Real = LaneReal<Num>;
  static constexpr int kWidth = Spread ? 1 : LaneTraits<Num>::width;

  explicit NumberReader(const Real* next) : next_(next) {}

  Num number() {
    const Real* const here = next_;
    next_ += kWidth;
    if constexpr (Spread)
      return Num(*here);
    else
      return load<Num>(here);
  }
  Vector3<Num> vector() {
    const Num x = number(), y = number();  // the order of arguments is not that of reading
    return {x, y, number()};
  }
  RigidTransform<Num> transform() {
    const Vector3<Num> x = vector(), y = vector(), z = vector();
    return {Rotation<Num>::from_columns(x, y, z), vector()};
  }

  /// A number that is affine in the displacements of V driving vectors.
  template <int V>
  Num affine(const WalkInput<Num>& in) {
    Num sum = number();
    for (int j = 0; j < V; ++j) {
      const Num linear = number();
      sum += in.delta_r[j] * linear;
    }
    return sum;
  }
  template <int V>
  Vector3<Num> affine_vector(const WalkInput<Num>& in) {
    if constexpr (V == 0) return {};
    const Num x = affine<V>(in), y = affine<V>(in);
    return {x, y, affine<V>(in)};
  }

 private:
  const Real* next_;
};

/// F turned about its z.
template <class Num>
RigidTransform<Num> turned(const RigidTransform<Num>& F, const SinCos<Num>& turn) {
  const Vector3<Num> x = F.rotation.column(0), y = F.rotation.column(1), z = F.rotation.column(2);
  return {Rotation<Num>::from_columns(turn.cosine * x + turn.sine * y, turn.cosine * y - turn.sine * x, z),
          F.translation};
}

/// Seen from axes that are turned about z.
template <class Num>
RigidTransform<Num> from_turned_axes(const RigidTransform<Num>& T, const SinCos<Num>& turn) {
  const auto seen = [&](Vector3<Num> v) {
    return Vector3<Num>{turn.cosine * v.x + turn.sine * v.y, turn.cosine * v.y - turn.sine * v.x, v.z};
  };
  const Rotation<Num>& R = T.rotation;
  return {Rotation<Num>::from_columns(seen(R.column(0)), seen(R.column(1)), seen(R.column(2))), seen(T.translation)};
}

/// Rises with the angle of (x, y) from -2 at -pi to 2 at pi, without an arc tangent.
template <class Num>
Num diamond_angle(Num y, Num x) {
  const Num part = y / (abs(x) + abs(y));
  return select(x < Num(0), select(y < Num(0), Num(-2), Num(2)) - part, part);
}

/// What a joint's fit needs of the points that it carries: h; P and the rows of M across its axis.
template <class Num>
struct TurnSums {
  Num hold, p_x, p_y;
  Vector3<Num> row_x, row_y;
};

template <class Num>
TurnSums<Num> turn_sums(const PointMoments<Num>& moments) {
  const Vector3<Num> p = moments.p, x = moments.pt[0], y = moments.pt[1], z = moments.pt[2];
  return {hold_of(p.x, p.y, moments.weight), p.x, p.y, {x.x, y.x, z.x}, {x.y, y.y, z.y}};
}

/// The sums of a joint that carries points on its own side of the lateral turn only.
template <int V, class Num, bool Spread>
TurnSums<Num> read_sums(const WalkInput<Num>& in, NumberReader<Num, Spread>& constants,
                        NumberReader<Num, Spread>& affine) {
  TurnSums<Num> sums;
  sums.hold = constants.number();
  sums.p_x = constants.number(), sums.p_y = constants.number();
  sums.row_x = affine.template affine_vector<V>(in), sums.row_y = affine.template affine_vector<V>(in);
  return sums;
}

/// The sums of a joint before the lateral one: the points beyond are seen through its turn.
template <int V, class Num, bool Spread>
TurnSums<Num> read_sums_before_lateral(const WalkInput<Num>& in, const SinCos<Num>& lateral,
                                       NumberReader<Num, Spread>& constants, NumberReader<Num, Spread>& affine) {
  TurnSums<Num> sums = read_sums<V>(in, constants, affine);
  const RigidTransform<Num> X = turned(constants.transform(), lateral);
  const std::array<Num, 9>& m = X.rotation.m;
  const Vector3<Num> X_x{m[0], m[1], m[2]}, X_y{m[3], m[4], m[5]};
  // P and M go through X, their weights W and T with them
  const Num weight = sums.hold, beyond = constants.number();
  const Vector3<Num> p = constants.vector();
  sums.p_x += dot(X_x, p) + beyond * X.translation.x;
  sums.p_y += dot(X_y, p) + beyond * X.translation.y;
  sums.hold = hold_of(sums.p_x, sums.p_y, weight);
  const Vector3<Num> t = affine.template affine_vector<V>(in);
  const Vector3<Num> pt_x = affine.template affine_vector<V>(in), pt_y = affine.template affine_vector<V>(in),
                     pt_z = affine.template affine_vector<V>(in);
  sums.row_x += Vector3<Num>{dot(X_x, pt_x), dot(X_x, pt_y), dot(X_x, pt_z)} + X.translation.x * t;
  sums.row_y += Vector3<Num>{dot(X_y, pt_x), dot(X_y, pt_y), dot(X_y, pt_z)} + X.translation.y * t;
  return sums;
}

/// A fitted joint's value, and where it was held at a limit.
template <class Num>
struct WalkFit {
  Num q;
  MaskOf<Num> at_limit;
};

/// The fit of docs/method.md#one-joint, seen from the joint's start, and `T`, its frame there, turned by it.
/// @param closed  where no weight is left: the joint stays
template <class Num, bool Spread>
WalkFit<Num> fit_turn(const TurnSums<Num>& sums, const std::array<Num, kLeadInputs>& leads, MaskOf<Num> closed,
                      NumberReader<Num, Spread>& constants, RigidTransform<Num>& T) {
  // targets in the joint's frame: along the present direction, and across it
  const Vector3<Num> x = T.rotation.column(0), y = T.rotation.column(1), o = T.translation;
  const Vector3<Num> row_x = sums.row_x - sums.p_x * o, row_y = sums.row_y - sums.p_y * o;
  const Num along = max(dot(row_x, x) + dot(row_y, y), Num(0)) + sums.hold;
  const Num across = dot(row_x, y) - dot(row_y, x);

  // turned on by the lead
  Num lead(0);
  for (const Num& input : leads) lead += input * constants.number();
  lead = select(closed, Num(0), lead);
  const Num sine = across + lead * along, cosine = along - lead * across;

  // within limits; the frame need not wait for the arc tangent: it compares angles by one that has no need of it
  const Num turn = diamond_angle(sine, cosine), per_length = Num(1) / sqrt(sine * sine + cosine * cosine);
  const Num start = constants.number();
  const Num lower = constants.number(), lower_turn = constants.number();
  const SinCos<Num> at_lower = {constants.number(), constants.number()};
  const Num upper = constants.number(), upper_turn = constants.number();
  const SinCos<Num> at_upper = {constants.number(), constants.number()};
  const MaskOf<Num> below = turn < lower_turn, above = upper_turn < turn;
  T = turned(T, {select(below, at_lower.sine, select(above, at_upper.sine, sine * per_length)),
                 select(below, at_lower.cosine, select(above, at_upper.cosine, cosine * per_length))});
  const Num q = clamp(start + atan2(sine, cosine), lower, upper);
  return {select(below, lower, select(above, upper, q)), below | above};
}

/// @tparam V       driving vectors; 0: no affine sum is read, `replace` has them all
/// @param replace  replace(step, sums): puts other sums in the place of the affine ones where these do not hold, and returns
///                 the lanes in which no weight is left at all
/// @param place    place(step, q, at_limit) takes the outcome
template <int V, bool Spread, class Num, class Replace, class Place>
void walk(const AffineBundle<LaneReal<Num>>& bundle, const WalkInput<Num>& in, const Replace& replace,
          const Place& place) noexcept {
  NumberReader<Num, Spread> constants(bundle.constants.data()),
      affine(V == 0 ? nullptr : bundle.affine[V == 0 ? 0 : V - 1].data());
  const auto fit = [&](int step, TurnSums<Num> sums, RigidTransform<Num>& T) {
    const MaskOf<Num> closed = replace(step, sums);
    const WalkFit<Num> fitted = fit_turn(sums, in.leads, closed, constants, T);
    place(step, fitted.q, fitted.at_limit);
  };
  const SinCos<Num> lateral = sincos(in.lateral);

  RigidTransform<Num> T = from_turned_axes(constants.transform(), sincos(in.azimuth));
  for (int s = 0; s < bundle.before; ++s) {
    fit(s, read_sums_before_lateral<V>(in, lateral, constants, affine), T);
    T = T * constants.transform();
  }
  T = turned(T, lateral);
  place(bundle.before, in.lateral, MaskOf<Num>(false));
  for (int s = bundle.before + 1; s < bundle.steps(); ++s) {
    T = T * constants.transform();
    fit(s, read_sums<V>(in, constants, affine), T);
  }
}

/// Calls `walk_for` with V as a constant, std::integral_constant<int, V>: sums are read without loops.
template <class WalkFor>
void with_vectors(int vectors, const WalkFor& walk_for) {
  switch (vectors) {
    case 1: return walk_for(std::integral_constant<int, 1>());
    case 2: return walk_for(std::integral_constant<int, 2>());
    case 3: return walk_for(std::integral_constant<int, 3>());
    default: static_assert(kMaxDrivingVectors == 4); return walk_for(std::integral_constant<int, 4>());
  }
}

}  // namespace uhas
