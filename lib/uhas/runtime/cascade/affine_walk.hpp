// The walk along an AffineBundle, from the palm to the tip: each joint is fitted with those before it final and those
// further out at their start. A template over its numbers, like the cascade.
#pragma once

#include <array>

#include "uhas/runtime/cascade/affine_pass.hpp"
#include "uhas/runtime/cascade/moments.hpp"
#include "uhas/runtime/cascade/plane_deformation.hpp"
#include "uhas/runtime/lanes/lane_math.hpp"

namespace uhas {

/// The deformation of a finger's plane, a finger or a hand a lane.
template <class Num>
struct WalkInput {
  int vectors;                                  ///< V, the same in all lanes
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

/// The sums of whole fingers, constants and what is affine in the displacements, step by step in their order.
template <int V, class Num, bool Spread>
class AffineSums {
 public:
  AffineSums(const AffineBundle<LaneReal<Num>>& bundle, const WalkInput<Num>& in)
      : in_(in),
        lateral_(sincos(in.lateral)),
        before_(bundle.before),
        constants_(bundle.sum_constants.data()),
        affine_(bundle.affine[V - 1].data()) {}

  TurnSums<Num> operator()(int step) { return step < before_ ? before_lateral() : on_one_side(); }

 private:
  /// Of a joint all of whose points lie on its own side of the lateral turn.
  TurnSums<Num> on_one_side() {
    TurnSums<Num> sums;
    sums.hold = constants_.number();
    sums.p_x = constants_.number(), sums.p_y = constants_.number();
    sums.row_x = affine_vector(), sums.row_y = affine_vector();
    return sums;
  }

  /// Of a joint before the lateral one: the points beyond are seen through its turn.
  TurnSums<Num> before_lateral() {
    TurnSums<Num> sums = on_one_side();
    const RigidTransform<Num> X = turned(constants_.transform(), lateral_);
    const std::array<Num, 9>& m = X.rotation.m;
    const Vector3<Num> X_x{m[0], m[1], m[2]}, X_y{m[3], m[4], m[5]};
    // P and M go through X, their weights W and T with them
    const Num weight = sums.hold, beyond = constants_.number();
    const Vector3<Num> p = constants_.vector();
    sums.p_x += dot(X_x, p) + beyond * X.translation.x;
    sums.p_y += dot(X_y, p) + beyond * X.translation.y;
    sums.hold = hold_of(sums.p_x, sums.p_y, weight);
    const Vector3<Num> t = affine_vector(), x = affine_vector(), y = affine_vector(), z = affine_vector();
    sums.row_x += Vector3<Num>{dot(X_x, x), dot(X_x, y), dot(X_x, z)} + X.translation.x * t;
    sums.row_y += Vector3<Num>{dot(X_y, x), dot(X_y, y), dot(X_y, z)} + X.translation.y * t;
    return sums;
  }

  Num affine() {
    Num sum = affine_.number();
    for (int j = 0; j < V; ++j) {
      const Num linear = affine_.number();
      sum += in_.delta_r[j] * linear;
    }
    return sum;
  }
  Vector3<Num> affine_vector() {
    const Num x = affine(), y = affine();
    return {x, y, affine()};
  }

  const WalkInput<Num>& in_;
  SinCos<Num> lateral_;
  int before_;
  NumberReader<Num, Spread> constants_, affine_;
};

/// Calls `use` with the AffineSums of the input's driving vectors: their number is a constant there.
template <bool Spread, class Num, class Use>
void with_affine_sums(const AffineBundle<LaneReal<Num>>& bundle, const WalkInput<Num>& in, const Use& use) {
  with_constant(in.vectors, [&](auto vectors) { use(AffineSums<vectors, Num, Spread>(bundle, in)); });
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
WalkFit<Num> fit_joint(const TurnSums<Num>& sums, const std::array<Num, kLeadInputs>& leads, MaskOf<Num> closed,
                       NumberReader<Num, Spread>& constants, RigidTransform<Num>& T) {
  // the joint stands at its start: along its present direction, and across it
  const TurnFit<Num> fit = fit_turn(sums, T);
  const Num along = max(fit.cosine, Num(0)) + sums.hold, across = fit.sine;

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
  return {select(below, lower, select(above, upper, q)), MaskOf<Num>(below | above)};
}

/// @param sums_of    sums_of(step): TurnSums, asked for each fitted joint in order
/// @param closed_at  closed_at(step): where closing has left no weight
/// @param place      place(step, q, at_limit) takes the outcome
template <bool Spread, class Num, class SumsOf, class ClosedAt, class Place>
void walk(const AffineBundle<LaneReal<Num>>& bundle, const WalkInput<Num>& in, SumsOf sums_of,
          const ClosedAt& closed_at, const Place& place) noexcept {
  NumberReader<Num, Spread> constants(bundle.constants.data());
  const auto fit = [&](int step, RigidTransform<Num>& T) {
    const WalkFit<Num> fitted = fit_joint(sums_of(step), in.leads, closed_at(step), constants, T);
    place(step, fitted.q, fitted.at_limit);
  };

  RigidTransform<Num> T = from_turned_axes(constants.transform(), sincos(in.azimuth));
  for (int s = 0; s < bundle.before; ++s) {
    fit(s, T);
    T = T * constants.transform();
  }
  T = turned(T, sincos(in.lateral));
  place(bundle.before, in.lateral, MaskOf<Num>(false));
  for (int s = bundle.before + 1; s < bundle.steps(); ++s) {
    T = T * constants.transform();
    fit(s, T);
  }
}

}  // namespace uhas
