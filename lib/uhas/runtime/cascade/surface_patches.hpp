// The surface points of a hand as the solver reads them, and the patches that they form: compiled once.
#pragma once

#include <array>
#include <vector>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/cascade/moments.hpp"
#include "uhas/runtime/cascade/plane_groups.hpp"

namespace uhas {

/// A surface point of a finger.
template <class Real>
struct SolverPoint {
  int joint{};
  int finger{};             ///< whose plane it follows
  Vector3<Real> p;          ///< in the joint's moved frame
  Vector3<Real> direction;  ///< of the material point on the sphere, unit, in S
  Real rho{}, phi{}, weight{};
  int plane_before{}, plane_after{};  ///< groups of planes on either side, for the interpolated field
  Real blend{};                       ///< 0 at plane_before, 1 at plane_after
};

/// The points of a patch column by column, as lanes read them; filled up with points of no weight.
template <class Real>
struct PointColumns {
  static constexpr std::size_t kWidest = 8;  ///< lengths are multiples of this

  std::size_t count{};   ///< points
  std::size_t length{};  ///< with those of no weight
  std::vector<Real> phi, rho, weight;
  std::array<std::vector<Real>, 3> p, direction;
};

/// The points of one finger on one joint, by polar angle. Where no point fades, targets are linear in the displacement,
/// which is linear in phi between driving vectors: two sets of sums take the place of the points
/// (docs/method.md#sums-of-a-patch).
template <class Real>
struct SolverPatch {
  int joint{}, finger{};
  bool first_of_joint{};  ///< of the joint's patches
  Real least_phi{}, greatest_phi{}, least_rho{};
  PointMoments<Real> rest;                      ///< undeformed
  std::vector<TargetMoments<Real>> beyond;      ///< [point] of this and all later points, targets `direction`
  std::vector<TargetMoments<Real>> beyond_phi;  ///< [point] of this and all later points, targets phi `direction`
  PointColumns<Real> columns;
};

/// Every weighted correspondence on a finger, sorted by joint, finger and polar angle.
template <class Real>
std::vector<SolverPoint<Real>> compile_points(const HandProfile& profile, const PlaneGroups& groups);

/// The patches of `points`, in their order.
template <class Real>
std::vector<SolverPatch<Real>> compile_patches(const std::vector<SolverPoint<Real>>& points);

}  // namespace uhas
