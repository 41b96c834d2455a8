// A rigid transform as files and other libraries hold it.
#pragma once

#include <array>

#include "uhas/base/rigid_transform.hpp"

namespace uhas {

/// The homogeneous matrix, row-major: element (i, j) is number 4 i + j.
template <class Number = double>
constexpr std::array<Number, 16> homogeneous_matrix(const RigidTransformd& T) {
  const auto n = [](double x) { return static_cast<Number>(x); };
  const auto& R = T.rotation.m;
  const Vector3d& p = T.translation;
  return {n(R[0]), n(R[1]), n(R[2]), n(p.x),  //
          n(R[3]), n(R[4]), n(R[5]), n(p.y),  //
          n(R[6]), n(R[7]), n(R[8]), n(p.z),  //
          0,       0,       0,       1};
}

}  // namespace uhas
