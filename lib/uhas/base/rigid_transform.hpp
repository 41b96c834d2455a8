// Rigid transforms. A name `T_a_b` maps coordinates of frame b to coordinates of frame a.
#pragma once

#include "uhas/base/vector3.hpp"

namespace uhas {

template <class Real>
struct RigidTransform {
  Rotation<Real> rotation;
  Vector3<Real> translation;

  /// Maps a point (rotated and shifted); directions take `rotation` alone.
  friend constexpr Vector3<Real> operator*(const RigidTransform& T, Vector3<Real> p) {
    return T.rotation * p + T.translation;
  }
  friend constexpr RigidTransform operator*(const RigidTransform& A, const RigidTransform& B) {
    return {A.rotation * B.rotation, A.rotation * B.translation + A.translation};
  }
  friend constexpr bool operator==(const RigidTransform& A, const RigidTransform& B) = default;

  template <class To>
  constexpr RigidTransform<To> cast() const {
    return {rotation.template cast<To>(), translation.template cast<To>()};
  }
  constexpr RigidTransform inverse() const {
    const Rotation<Real> Rt = rotation.transposed();
    return {Rt, -(Rt * translation)};
  }
};

using RigidTransformd = RigidTransform<double>;

}  // namespace uhas
