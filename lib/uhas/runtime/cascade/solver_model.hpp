// The constant half of the solver: a profile compiled for one number type. Lengths are in sphere radii and every
// joint's axis is the z of its frame: both make the arithmetic of a solve shorter. Made by solver_model.cpp.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "uhas/kinematics/cascade_plan.hpp"
#include "uhas/kinematics/compiled_joint.hpp"
#include "uhas/kinematics/joint_travel.hpp"
#include "uhas/runtime/cascade/action_decoder.hpp"
#include "uhas/runtime/cascade/affine_pass.hpp"
#include "uhas/runtime/cascade/plane_groups.hpp"
#include "uhas/runtime/cascade/surface_patches.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/lanes/lane_math.hpp"

namespace uhas {

/// A joint with its limits and its way. The base is S, lengths are sphere radii, those of q too.
template <class Real>
struct SolverJoint : CompiledJoint<Real> {
  Real unit{};                    ///< profile units of q per solver unit: r for a prismatic joint, else 1
  Real least{}, greatest{};       ///< profile units: the limits; of a mimic follower infinite
  JointValue<Real> lower, upper;  ///< solver units, like every joint value below
  JointTravel<Real> travel;

  /// Factor on the moments that go from the joint to its parent: one unknown more between.
  template <class Num>
  Num decay_inward(Num decay) const {
    return this->follows ? Num(1) : decay;
  }

  template <class Num>
  JointValue<Num> value(Num q) const {
    if (this->prismatic) return {q, Num(1), Num(0)};
    const SinCos<Num> turn = sincos(q);
    return {q, turn.cosine, turn.sine};
  }

  /// `q` in profile units, which for a turn are those of the solver: the product may round past a limit, the result is
  /// never beyond it.
  template <class Num>
  Num in_profile_units(Num q) const {
    return this->prismatic ? clamp(q * Num(unit), Num(least), Num(greatest)) : q;
  }
};

/// Where a joint stands before the cascade.
template <class Real>
struct SolverStart {
  JointValue<Real> value;  ///< q_sphere, or open for what a contact is sought for
  RigidTransform<Real>
      decayed_T_parent_moved;  ///< the joint's frame moved by `value`, times `decay_inward` of the first pass
};

/// How far the first fit of a joint goes ahead for the joints further out, rad a radius of each input (lead.hpp).
template <class Real>
using SolverLead = std::array<Real, kLeadInputs>;

/// The fingertip of a finger.
template <class Real>
struct SolverTip {
  int joint{};
  Vector3<Real> p;  ///< in the joint's moved frame
};

/// A lateral joint and its table (docs/method.md#lateral-tables).
template <class Real>
struct SolverLateral {
  int joint{}, finger{};
  Real lower{}, upper{};        ///< bounds of delta theta, rad
  std::vector<Real> inverse_q;  ///< as `look_up_lateral` takes it, solver units
};

/// A joint of a part of the tree; `inner` says that its parent belongs to that part too and moves with a step, so that
/// the parent carries its points.
struct ScopedJoint {
  int joint;
  bool inner;
};

/// A step of the cascade and the joints whose frames depend on it.
struct SolverStep : CascadeStep {
  int first_finger{};                       ///< of `fingers`
  bool single{};                            ///< one joint, without followers
  std::vector<std::pair<int, int>> nested;  ///< driven turning joints of which the first carries the second
  std::vector<ScopedJoint> scope;           ///< driven joints and all joints further out, in tree order
};

/// A part of the hand that no other part moves: a finger, or fingers that share a joint. Parts are solved one after the
/// other, so that the memory one needs stays near.
struct SolverPart {
  std::vector<ScopedJoint> tree;  ///< its joints, in tree order
  std::vector<int> fingers;
  std::vector<int> laterals;           ///< indices into `SolverModel::laterals`
  std::vector<int> lateral_followers;  ///< joints that mimic one of these
  std::vector<int> steps;              ///< indices into `SolverModel::steps`, in solving order
};

/// One sweep over a part.
template <class Real>
struct SolverPass {
  Real decay;  ///< factor on a point's weight for each unknown between it and a joint
  bool first;  ///< the joints further out stand at their start: a fit leads
};

/// Made in one go by `compile_solver_model`, and constant from then on.
template <class Real>
struct SolverModel {
  SolveOptions options;
  ActionDecoder<Real> decoder;
  Real azimuth_sign;  ///< -1 on a mirrored hand: azimuth = sign * canonical azimuth
  std::vector<SolverPass<Real>> passes;
  std::vector<SolverJoint<Real>> joints;
  std::vector<SolverStart<Real>> starts;  ///< [joint]
  std::vector<SolverLead<Real>> leads;    ///< [joint]
  std::vector<SolverTip<Real>> tips;      ///< [finger]
  std::vector<SolverLateral<Real>> laterals;
  std::vector<SolverStep> steps;
  std::vector<int> step_at;  ///< [joint] the step solved when the sweep reaches the joint; -1 = none
  PlaneGroups plane_groups;
  std::vector<SolverPoint<Real>> points;  ///< sorted by patch
  std::vector<SolverPatch<Real>> patches;
  std::vector<std::vector<int>> patches_of_finger;  ///< [finger] indices into `patches`, of those that a step moves
  std::vector<SolverPart> parts;
  std::vector<AffineBundle<Real>> lone_fingers;  ///< of one finger each: those that have an affine form
  std::vector<int> other_parts;                  ///< indices into `parts`, of those that have none
};

/// Throws Error: invalid_profile for a profile that `validate_profile` refuses, invalid_option for passes or numbers of
/// the convention out of range.
template <class Real>
std::shared_ptr<const SolverModel<Real>> compile_solver_model(const HandProfile& profile, const SolveOptions& options);

}  // namespace uhas
