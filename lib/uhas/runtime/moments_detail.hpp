// Weighted moments of point pairs: all that the least-squares fit of a joint needs to know of its surface points.
//
// A joint's fit needs sums over points p (in a link frame) and targets t (in S). Such sums can be moved between frames and
// added without going back to the points, so a solve visits each point once, however many joints carry it.
#pragma once

#include "uhas/base/rigid_transform.hpp"

namespace uhas {

template <class Real>
struct PointMoments {
  Real full_weight{};                ///< sum w, dropped points included
  Real weight{};                     ///< sum w s, s = the share of the point that closing has left
  Vector3<Real> p;                   ///< sum w s p
  Vector3<Real> t;                   ///< sum w s t
  Rotation<Real> pt{{0, 0, 0, 0, 0, 0, 0, 0, 0}};  ///< sum w s p t^T (any matrix, row-major)

  /// Adds a point whose share closing has left.
  void add(Real w, Real share, Vector3<Real> point, Vector3<Real> target) {
    full_weight += w;
    const Real ws = w * share;
    weight += ws;
    const Vector3<Real> wt = ws * target;
    p += ws * point;
    t += wt;
    add_outer(point, wt);
  }

  /// Turns every target about the z of S: t becomes R t, hence p t^T becomes p t^T R^T.
  void turn_targets(Real c, Real s) {
    t = {c * t.x - s * t.y, s * t.x + c * t.y, t.z};
    for (int row = 0; row < 9; row += 3) {
      const Real x = pt.m[row], y = pt.m[row + 1];
      pt.m[row] = c * x - s * y;
      pt.m[row + 1] = s * x + c * y;
    }
  }

  /// Adds `factor` times the targets of `other`, whose points and weights are the same.
  void add_targets(const PointMoments& other, Real factor) {
    t += factor * other.t;
    for (int i = 0; i < 9; ++i) pt.m[i] += factor * other.pt.m[i];
  }

  /// Adds `factor` times `other`, whose points are in a frame that `T` maps to this one's.
  void add_transformed(const PointMoments& other, const RigidTransform<Real>& T, Real factor) {
    full_weight += factor * other.full_weight;
    weight += factor * other.weight;
    p += factor * (T.rotation * other.p + other.weight * T.translation);
    t += factor * other.t;
    const Rotation<Real> rotated = T.rotation * other.pt;
    for (int i = 0; i < 9; ++i) pt.m[i] += factor * rotated.m[i];
    add_outer(T.translation, factor * other.t);
  }

 private:
  void add_outer(Vector3<Real> a, Vector3<Real> b) {
    pt.m[0] += a.x * b.x, pt.m[1] += a.x * b.y, pt.m[2] += a.x * b.z;
    pt.m[3] += a.y * b.x, pt.m[4] += a.y * b.y, pt.m[5] += a.y * b.z;
    pt.m[6] += a.z * b.x, pt.m[7] += a.z * b.y, pt.m[8] += a.z * b.z;
  }
};

/// What a joint sees of its points, all in the joint's frame F before its own motion, whose z is the joint's axis.
template <class Real>
struct JointFit {
  Real sine{};    ///< sum w s z . (p x t)
  Real cosine{};  ///< sum w s (p_x t_x + p_y t_y)
  Real shift{};   ///< sum w s z . (t - p)
};

/// Targets go to F by t_F = R^T (t - o), so that sum p t_F^T = (sum p t^T - sum p o^T) R; only the rows and columns across the
/// axis count.
/// @param moments  points in F at joint value 0, targets in S
/// @param T_S_F    F in S
template <class Real>
JointFit<Real> fit_joint(const PointMoments<Real>& moments, const RigidTransform<Real>& T_S_F) {
  const std::array<Real, 9>& m = moments.pt.m;
  const Vector3<Real> o = T_S_F.translation, p = moments.p;
  const Vector3<Real> row_x = Vector3<Real>{m[0], m[1], m[2]} - p.x * o, row_y = Vector3<Real>{m[3], m[4], m[5]} - p.y * o;
  const Vector3<Real> x = T_S_F.rotation.column(0), y = T_S_F.rotation.column(1), z = T_S_F.rotation.column(2);
  return {.sine = dot(row_x, y) - dot(row_y, x),
          .cosine = dot(row_x, x) + dot(row_y, y),
          .shift = dot(z, moments.t - moments.weight * o) - p.z};
}

}  // namespace uhas
