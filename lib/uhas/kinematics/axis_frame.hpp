// The frame in which a joint's axis is z: there its motion touches two coordinates only.
#pragma once

#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// A rotation whose z is the joint's axis, in the joint frame; its x and y are any that suit.
inline Rotationd axis_frame(const Joint& joint) {
  const Vector3d z = normalized(joint.axis), x = any_orthogonal(z);
  return Rotationd::from_columns(x, cross(z, x), z);
}

}  // namespace uhas
