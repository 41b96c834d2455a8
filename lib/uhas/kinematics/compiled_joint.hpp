// A joint made ready for kinematics that run often: its axis is the z of its frame, its mimic relation is folded in, so
// that only independent joints are read, and lengths have the unit that the reader works in.
#pragma once

#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// How far a joint moves, and what decides that.
template <class Real>
struct JointMotion {
  bool prismatic = false;   ///< a shift along z, else a turn about z
  bool follows = false;     ///< mimics another joint
  int source = -1;          ///< the independent joint that decides: itself, or the master it mimics
  Real ratio{1}, offset{};  ///< motion = ratio q[source] + offset, rad or lengths

  bool mimics(int joint) const { return follows && source == joint; }

  /// The motion for `q` of the source.
  template <class Num>
  Num motion_at(const Num& q) const {
    return Num(ratio) * q + Num(offset);
  }

  /// The same numbers in another type.
  template <class To>
  JointMotion<To> cast() const {
    return {prismatic, follows, source, static_cast<To>(ratio), static_cast<To>(offset)};
  }
};

/// A motion with what it needs: cosine and sine of a turn; 1 and 0 for a shift.
template <class Num>
struct JointValue {
  Num q{}, cosine{1}, sine{};

  template <class To>
  JointValue<To> cast() const {
    return {To(q), To(cosine), To(sine)};
  }
};

template <class Real>
struct CompiledJoint : JointMotion<Real> {
  int parent = -1;                      ///< -1 = the base
  RigidTransform<Real> T_parent_joint;  ///< the frame before its motion in the parent's moved frame; z is the axis

  /// Frame F of the joint, moved by `value`.
  template <class Num>
  RigidTransform<Num> moved(const RigidTransform<Num>& F, const JointValue<Num>& value) const {
    // a shift moves the origin along z, a turn rotates x and y about it
    const Vector3<Num> x = F.rotation.column(0), y = F.rotation.column(1), z = F.rotation.column(2);
    if (this->prismatic) return {F.rotation, F.translation + value.q * z};
    return {Rotation<Num>::from_columns(value.cosine * x + value.sine * y, value.cosine * y - value.sine * x, z),
            F.translation};
  }

  template <class To>
  CompiledJoint<To> cast() const {
    return {JointMotion<Real>::template cast<To>(), parent, T_parent_joint.template cast<To>()};
  }
};

/// What counts as one length, in metres.
struct LengthUnits {
  double motion = 1;  ///< in frames, and in the motions of sliding joints
  double q = 1;       ///< in the q of sliding joints
};

/// @param T_base_root  the tree's root frame in the frame in which joints without a parent are placed (m)
CompiledJoint<double> compile_joint(const KinematicTree& tree, int joint, const RigidTransformd& T_base_root,
                                    const LengthUnits& units);

}  // namespace uhas
