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

  void add(Real w, Real share, Vector3<Real> point, Vector3<Real> target) {
    full_weight += w;
    const Real ws = w * share;
    weight += ws;
    const Vector3<Real> wt = ws * target;
    p += ws * point;
    t += wt;
    add_outer(point, wt);
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

/// What a joint sees of its points, all in the joint's frame F before its own motion.
template <class Real>
struct JointFit {
  Real sine{};    ///< sum w s a . (p x t)
  Real cosine{};  ///< sum w s p_orthogonal . t_orthogonal
  Real shift{};   ///< sum w s a . (t - p)
};

/// @param moments  points in F at joint value 0, targets in S
/// @param T_S_F    F in S, @param axis unit axis in F
template <class Real>
JointFit<Real> fit_joint(const PointMoments<Real>& moments, const RigidTransform<Real>& T_S_F, Vector3<Real> axis) {
  // targets to F: t_F = R^T (t - o), so sum p t_F^T = (sum p t^T - sum p o^T) R
  PointMoments<Real> centred = moments;
  const Vector3<Real> o = T_S_F.translation;
  const Vector3<Real> p = moments.p;
  centred.pt.m = {moments.pt.m[0] - p.x * o.x, moments.pt.m[1] - p.x * o.y, moments.pt.m[2] - p.x * o.z,
                  moments.pt.m[3] - p.y * o.x, moments.pt.m[4] - p.y * o.y, moments.pt.m[5] - p.y * o.z,
                  moments.pt.m[6] - p.z * o.x, moments.pt.m[7] - p.z * o.y, moments.pt.m[8] - p.z * o.z};
  const std::array<Real, 9> M = (centred.pt * T_S_F.rotation).m;
  const Vector3<Real> t = T_S_F.rotation.transposed() * (moments.t - moments.weight * o);

  const Vector3<Real> crossed{M[5] - M[7], M[6] - M[2], M[1] - M[3]};  // sum p x t
  const Vector3<Real> M_axis = Rotation<Real>{M} * axis;
  return {dot(axis, crossed), M[0] + M[4] + M[8] - dot(axis, M_axis), dot(axis, t - p)};
}

}  // namespace uhas
