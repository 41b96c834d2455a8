// Weighted moments of point pairs (docs/method.md#moments): all that the least-squares fit of a joint needs to know of
// its surface points.
//
// A joint's fit needs sums over points p (in a link frame) and targets t (in S). Such sums can be moved between frames
// and added without going back to the points, so a solve visits each point at most once, however many joints carry it.
#pragma once

#include <array>

#include "uhas/base/rigid_transform.hpp"
#include "uhas/runtime/lanes/lanes.hpp"

namespace uhas {

/// The sums that targets take part in.
template <class Num>
struct TargetMoments {
  Vector3<Num> t;                    ///< T = sum w s t
  std::array<Vector3<Num>, 3> pt{};  ///< the columns of M: pt[j] = sum w s t_j p

  /// Adds `factor` times the targets of `other`, whose points and shares are the same.
  template <class Real>
  void add_targets(const TargetMoments<Real>& other, Num factor) {
    t += factor * other.t.template cast<Num>();
    for (int j = 0; j < 3; ++j) pt[j] += factor * other.pt[j].template cast<Num>();
  }

  /// Adds a pair; `wt` is the target times its weight and share.
  void add_pair(Vector3<Num> point, Vector3<Num> wt) {
    t += wt;
    pt[0] += wt.x * point;
    pt[1] += wt.y * point;
    pt[2] += wt.z * point;
  }

  /// Turns every target about the z of S by the angle of this cosine and sine.
  void turn_targets(Num cosine, Num sine) {
    t = {cosine * t.x - sine * t.y, sine * t.x + cosine * t.y, t.z};
    const Vector3<Num> x = pt[0], y = pt[1];
    pt[0] = cosine * x - sine * y;
    pt[1] = sine * x + cosine * y;
  }
};

/// `factor` times both parts of T: of a moment of points and their weights it makes `factor` times what T makes.
template <class Num>
RigidTransform<Num> scaled(RigidTransform<Num> T, Num factor) {
  for (Num& number : T.rotation.m) number *= factor;
  return {T.rotation, factor * T.translation};
}

/// All the sums over the points of a joint.
template <class Num>
struct PointMoments : TargetMoments<Num> {
  Num full_weight{};  ///< sum w, dropped points included
  Num weight{};       ///< W = sum w s, s = the share of the point that closing has left
  Vector3<Num> p;     ///< P = sum w s p

  /// Adds a point of which closing has left `share`.
  void add(Num w, Num share, Vector3<Num> point, Vector3<Num> target) {
    full_weight += w;
    weight += w * share;
    p += (w * share) * point;
    this->add_pair(point, (w * share) * target);
  }

  /// Adds `factor` times `other`, whose points are in a frame that T maps to this one's: (p, weight) and each (pt[j],
  /// t_j) are sums of points and of their weights, so that T maps the one with the other's help.
  /// @param scaled_T  `factor` times T
  void add_transformed(const PointMoments& other, const RigidTransform<Num>& scaled_T, Num factor) {
    // P' = R P + W o, and the same for each column of M with the weight T_j
    const auto moved = [&](Vector3<Num> points, Num weights) {
      return scaled_T.rotation * points + weights * scaled_T.translation;
    };
    full_weight += factor * other.full_weight;
    weight += factor * other.weight;
    p += moved(other.p, other.weight);
    this->t += factor * other.t;
    this->pt[0] += moved(other.pt[0], other.t.x);
    this->pt[1] += moved(other.pt[1], other.t.y);
    this->pt[2] += moved(other.pt[2], other.t.z);
  }

  /// Adds `other`, whose points are in the same frame.
  void add(const PointMoments& other) {
    full_weight += other.full_weight;
    weight += other.weight;
    p += other.p;
    this->add_targets(other, Num(1));
  }
};

/// Share of the points' own weight that holds a joint at its present value (docs/method.md#hold).
inline constexpr double kHold = 0.5;

/// The hold h: half of the points' own weight keeps the joint where it is, or it would spin where targets come close to
/// the axis and the sums nearly cancel (docs/method.md#hold). With no weight at all it is all there is.
/// @param p_x, p_y, weight  of the moments, in the joint's frame
template <class Num>
Num hold_of(Num p_x, Num p_y, Num weight) {
  const Num least(LaneReal<Num>(1e-15f));
  return Num(LaneReal<Num>(kHold)) * (p_x * p_x + p_y * p_y) / (weight + least * least) + least;
}

/// What a turning joint needs of the points that it carries: h; P and the rows of M across its axis.
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

/// What it sees of them in its frame F before its own motion, whose z is its axis.
template <class Num>
struct TurnFit {
  Num sine{};    ///< D = sum w s z . (p x t)
  Num cosine{};  ///< C = sum w s (p_x t_x + p_y t_y)
};

/// Targets go to F by t_F = R^T (t - o), so that sum p t_F^T = (sum p t^T - sum p o^T) R; only the rows and columns
/// across the axis count.
/// @param sums   points in F at joint value 0, targets in S
/// @param T_S_F  F in S
template <class Num>
TurnFit<Num> fit_turn(const TurnSums<Num>& sums, const RigidTransform<Num>& T_S_F) {
  // two rows of M - P o^T
  const Vector3<Num> o = T_S_F.translation, row_x = sums.row_x - sums.p_x * o, row_y = sums.row_y - sums.p_y * o;
  // times the x and y of F: D = M_12 - M_21, C = M_11 + M_22
  const Vector3<Num> x = T_S_F.rotation.column(0), y = T_S_F.rotation.column(1);
  return {.sine = dot(row_x, y) - dot(row_y, x), .cosine = dot(row_x, x) + dot(row_y, y)};
}

/// What a sliding joint sees of them: sum w s z . (t - p).
template <class Num>
Num fit_shift(const PointMoments<Num>& moments, const RigidTransform<Num>& T_S_F) {
  return dot(T_S_F.rotation.column(2), moments.t - moments.weight * T_S_F.translation) - moments.p.z;
}

/// How two turning joints of one chain bend the cost together: the second derivative of sum w s p . t, with the outer
/// one's points. With p from the outer joint's origin and t from the inner one's it is z_in . ((z_out x p) x t) = (z_in
/// . p) (z_out . t) - (z_in . z_out) (p . t).
/// @param moments       points that the outer joint carries, in its moved frame
/// @param T_in, T_out   the joints' moved frames in S; their z are the axes
template <class Num>
Num bend_of_pair(const PointMoments<Num>& moments, const RigidTransform<Num>& T_in, const RigidTransform<Num>& T_out) {
  const Vector3<Num> o = T_in.translation, z_in = T_in.rotation.column(2), z_out = T_out.rotation.column(2);
  // the points, from the outer origin, turned into S: x, y, z are the columns of M there
  const Vector3<Num> x = T_out.rotation * moments.pt[0], y = T_out.rotation * moments.pt[1],
                     z = T_out.rotation * moments.pt[2], p = T_out.rotation * moments.p;
  // sum w s (z_out . t) p, then z_in . (that) - (z_in . z_out) sum w s p . t
  const Vector3<Num> along = z_out.x * x + z_out.y * y + z_out.z * z - dot(z_out, o) * p;
  return dot(z_in, along) - dot(z_in, z_out) * (x.x + y.y + z.z - dot(p, o));
}

}  // namespace uhas
