// The first pass of whole fingers as constants of the hand (docs/method.md#whole-fingers).
//
// While the first pass fits a joint, the joints further out stand at their start. The sums that it carries are then
// affine in the displacements of its plane, as long as none of the finger's points fades:
// S = S_0 + sum_j delta_r_j S_j. They are made once, when a solver is; a solve walks from the palm to the tip
// (affine_walk.hpp). The azimuth turns no sum: the finger's frames are seen from axes that turn along.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

template <class Real>
struct SolverModel;

/// A finger that stands alone: a plain chain of joints without followers, every step a single turn, at most one lateral.
template <class Real>
struct AffineFinger {
  int finger = -1;
  int part = -1;                             ///< index into `SolverModel::parts`
  int lateral = -1;                          ///< index into `SolverModel::laterals`; -1 = none
  Real lowest{};                             ///< least displacement at which no point fades or passes the centre, radii
  std::vector<int> joints;                   ///< [step of the bundle] that the step turns; -1 = nothing
  std::vector<std::pair<int, Real>> others;  ///< joints that no step turns, and where they stand, solver units
};

/// Fingers that are walked together, a finger a lane; or one finger, for a hand a lane. The steps are the same in all
/// lanes: fits of joints before the lateral one, the turn of the lateral joint, fits beyond it. A finger with fewer
/// joints goes through the others with nothing to do.
template <class Real>
struct AffineBundle {
  int width = 1;                            ///< lanes; those past the last finger repeat it
  int before = 0, beyond = 0;               ///< steps that fit a joint, before and beyond the lateral turn
  std::vector<AffineFinger<Real>> fingers;  ///< [at most width]

  // numbers in the order in which they are read, [numbers][width]
  std::vector<Real> constants;      ///< frames, leads, starts and limits
  std::vector<Real> sum_constants;  ///< of the sums what no displacement changes
  /// [V - 1] of the sums what is affine in the displacements of V driving vectors at their default angles: each number at
  /// rest, then a radius of each displacement more.
  std::array<std::vector<Real>, kMaxDrivingVectors> affine;

  int steps() const noexcept { return before + 1 + beyond; }
};

/// Bundles of `width` of those fingers of `model` that have an affine form; none for more than one pass, for the rule
/// `contact` and for the reading `field`.
template <class Real>
std::vector<AffineBundle<Real>> bundle_fingers(const SolverModel<Real>& model, int width);

}  // namespace uhas
