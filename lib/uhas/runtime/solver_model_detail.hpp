// The constant half of the solver: a profile compiled for one number type.
// Lengths are in sphere radii and every joint's axis is the z of its frame: both make the arithmetic of a solve shorter.
#pragma once

#include <vector>

#include "uhas/runtime/action_decoder_detail.hpp"
#include "uhas/runtime/cascade_plan.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/contact.hpp"
#include "uhas/runtime/moments_detail.hpp"

namespace uhas {

/// A joint value with what its motion needs: cosine and sine of a turn; 1 and 0 for a slide.
template <class Real>
struct JointValue {
  Real q{}, cosine{1}, sine{};
};

template <class Real>
struct SolverJoint {
  bool prismatic = false;
  int parent = -1;                      ///< -1 = S itself: roots have the palm folded in
  RigidTransform<Real> T_parent_joint;  ///< z is the axis
  Real unit{};                          ///< profile units of q per solver unit: r for a prismatic joint, else 1
  JointValue<Real> lower, upper;        ///< solver units, like every joint value below
  JointValue<Real> start;               ///< before the cascade: q_sphere, or open for what a contact is sought for
  Real q_closed{};
  JointTravel<Real> travel;
  Real branch_start{};                  ///< fitted angles are taken from [branch_start, branch_start + 2 pi)
  int master = -1;
  Real multiplier{1}, offset{};

  JointValue<Real> value(Real q) const {
    if (prismatic) return {q, Real(1), Real(0)};
    return {q, std::cos(q), std::sin(q)};
  }

  /// Frame F of the joint, moved by `value`: a turn about, or a shift along, its z.
  RigidTransform<Real> moved(const RigidTransform<Real>& F, const JointValue<Real>& value) const {
    const Vector3<Real> x = F.rotation.column(0), y = F.rotation.column(1), z = F.rotation.column(2);
    if (prismatic) return {F.rotation, F.translation + value.q * z};
    return {Rotation<Real>::from_columns(value.cosine * x + value.sine * y, value.cosine * y - value.sine * x, z), F.translation};
  }
};

/// A surface point of a finger.
template <class Real>
struct SolverPoint {
  int joint{};
  int finger{};
  Vector3<Real> p;          ///< in the joint's moved frame
  Vector3<Real> direction;  ///< of the material point on the sphere, unit, in S
  Real rho{}, phi{}, weight{};
  int plane_before{}, plane_after{};  ///< groups of planes on either side, for the interpolated field
  Real blend{};                       ///< 0 at plane_before, 1 at plane_after
};

/// The points of one finger on one joint: [first, last). Targets are linear in the displacements as long as no point fades, so
/// their moments are those at rest plus one set for each driving vector at its default angle.
template <class Real>
struct SolverPatch {
  int joint{}, finger{};
  std::size_t first{}, last{};
  Real least_rho{};
  PointMoments<Real> rest;                                                  ///< undeformed
  std::array<std::vector<PointMoments<Real>>, kMaxDrivingVectors> per_unit;  ///< [V - 1][j] targets for d r_j = 1, others 0
};

template <class Real>
struct SolverLateral {
  int joint{}, finger{};
  Real lower{}, upper{};
  std::vector<Real> inverse_q;
};

/// A joint of a part of the tree; `inner` says that its parent belongs to that part too.
struct ScopedJoint {
  int joint;
  bool inner;
};

/// A step of the cascade and the joints whose frames depend on it.
struct SolverStep : CascadeStep {
  std::vector<ScopedJoint> scope;  ///< driven joints and all joints further out, in tree order
};

template <class Real>
struct SolverModel {
  SolverModel(const HandProfile& profile, const SolveOptions& solve_options);

  SolveOptions options;
  ActionDecoder<Real> decoder;
  Real azimuth_sign{1};                        ///< -1 on a mirrored hand: azimuth = sign * canonical azimuth
  std::vector<SolverJoint<Real>> joints;
  std::vector<SolverPoint<Real>> points;       ///< sorted by patch
  std::vector<SolverPatch<Real>> patches;
  std::vector<SolverLateral<Real>> laterals;
  std::vector<SolverStep> steps;
  std::vector<ScopedJoint> whole_tree;
  std::vector<int> step_at;                    ///< [joint] the step solved when the sweep reaches the joint; -1 = none
  std::vector<int> tip_joint;                  ///< [finger]
  std::vector<Vector3<Real>> p_tip;            ///< [finger] in the tip joint's moved frame
  std::vector<std::vector<int>> plane_groups;  ///< fingers whose planes stand closer than 5 degrees, by azimuth
  std::vector<int> group_of_finger;            ///< [finger] index into `plane_groups`
};

extern template struct SolverModel<float>;
extern template struct SolverModel<double>;

}  // namespace uhas
