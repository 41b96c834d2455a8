// The constant half of the solver: a profile compiled into sphere units (lengths divided by r) and one number type.
#pragma once

#include <vector>

#include "uhas/runtime/action_decoder_detail.hpp"
#include "uhas/runtime/cascade_plan.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/contact.hpp"

namespace uhas {

template <class Real>
struct SolverJoint {
  bool prismatic = false;
  int parent = -1;                     ///< -1 = S itself: roots have the palm folded in
  RigidTransform<Real> T_parent_joint;
  Vector3<Real> axis;
  Real unit{};                         ///< profile units of q per solver unit: r for a prismatic joint, else 1
  Real lower{}, upper{};               ///< solver units, like every joint value below
  Real q_start{};                      ///< before the cascade: q_sphere, or open for what a contact is sought for
  Real q_closed{};
  JointTravel<Real> travel;
  Real branch_start{};                 ///< fitted angles are taken from [branch_start, branch_start + 2 pi)
  int master = -1;
  Real multiplier{1}, offset{};
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
  Real azimuth_sign{1};                             ///< -1 on a mirrored hand: azimuth = sign * canonical azimuth
  std::vector<SolverJoint<Real>> joints;
  std::vector<SolverPoint<Real>> points;
  std::vector<SolverLateral<Real>> laterals;
  std::vector<SolverStep> steps;
  std::vector<ScopedJoint> whole_tree;
  std::vector<int> step_at;                         ///< [joint] the step solved when the sweep reaches the joint; -1 = none
  std::vector<int> tip_joint;                       ///< [finger]
  std::vector<Vector3<Real>> p_tip;                 ///< [finger] in the tip joint's moved frame
  std::vector<std::vector<int>> plane_groups;       ///< fingers whose planes stand closer than 5 degrees, by azimuth
  std::vector<int> group_of_finger;                 ///< [finger] index into `plane_groups`
};

extern template struct SolverModel<float>;
extern template struct SolverModel<double>;

}  // namespace uhas
