// One finger's chain of joints, made ready to place its fingertip with few operations.
#pragma once

#include <vector>

#include "uhas/kinematics/compiled_joint.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// A joint between its parent and what it carries. By the motion q' (rad or m) it moves a point p to
///   origin + Rx(tilt) Rz(q') p                     a turn
///   origin + Rx(tilt) Rz(turn) (p + q' z)          a slide
/// Any rotation is Rz(a) Rx(tilt) Rz(b). Here b has gone into the joint's own turn and a into its parent's.
template <class Real>
struct ChainJoint : JointMotion<Real> {
  Real turn_cosine{1}, turn_sine{};  ///< of a slide
  Real tilt_cosine{1}, tilt_sine{};
  Vector3<Real> origin{};  ///< m
};

template <class Real>
struct FingertipChain {
  Vector3<Real> p_tip;                   ///< in the last joint's frame (m)
  std::vector<ChainJoint<Real>> joints;  ///< fingertip to palm
  Real base_cosine{1}, base_sine{};      ///< a of the joint on the palm, about the palm frame's z
};

/// The chain from the palm to the fingertip of `profile.fingers[finger]`.
template <class Real>
FingertipChain<Real> compile_chain(const HandProfile& profile, int finger);

extern template FingertipChain<float> compile_chain(const HandProfile&, int);
extern template FingertipChain<double> compile_chain(const HandProfile&, int);

/// The fingertip in the palm frame (m). A point is carried inward, so that no frame is ever multiplied with another.
/// @param Value     Real, or lanes of it: then one call places the fingertips of as many hands
/// @param value_of  joint index -> Value: q of an independent joint (rad or m)
/// @param turn_of   called as turn_of(angle, cosine, sine): sets the last two
template <class Value, class Real, class ValueOf, class TurnOf>
Vector3<Value> place_fingertip(const FingertipChain<Real>& chain, ValueOf value_of, TurnOf turn_of) {
  Value x(chain.p_tip.x), y(chain.p_tip.y), z(chain.p_tip.z);
  for (const ChainJoint<Real>& joint : chain.joints) {
    // the joint's own motion about or along z
    const Value motion = joint.motion_at(value_of(joint.source));
    Value cosine(joint.turn_cosine), sine(joint.turn_sine);
    if (joint.prismatic)
      z = z + motion;
    else
      turn_of(motion, cosine, sine);
    const Value turned_x = cosine * x - sine * y, turned_y = sine * x + cosine * y;

    // into the parent's frame: a tilt about x, and the joint's place there
    x = Value(joint.origin.x) + turned_x;
    y = Value(joint.origin.y) + Value(joint.tilt_cosine) * turned_y - Value(joint.tilt_sine) * z;
    z = Value(joint.origin.z) + Value(joint.tilt_sine) * turned_y + Value(joint.tilt_cosine) * z;
  }

  // the turn that the joint on the palm could not give to a parent
  const Value cosine(chain.base_cosine), sine(chain.base_sine);
  return {cosine * x - sine * y, sine * x + cosine * y, z};
}

}  // namespace uhas
