// What wide instructions do for a single hand, behind a boundary of plain pointers: each instruction set has a compilation
// of its own, and all give the same bits.
#pragma once

#include "uhas/runtime/cascade/affine_pass.hpp"
#include "uhas/runtime/cascade/patch_moments.hpp"
#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {

/// Fingers that are walked side by side at most.
inline constexpr int kMostFingerLanes = 8;

/// What an action says to the fingers of a bundle: a WalkInput, a number a lane.
template <class Real>
struct FingerInput {
  int vectors;  ///< V
  Real delta_r[kMaxDrivingVectors][kMostFingerLanes];
  Real leads[kLeadInputs][kMostFingerLanes];
  Real azimuth[kMostFingerLanes], lateral[kMostFingerLanes];
};

/// Numbers of a TurnSums.
inline constexpr int kTurnSums = 9;

/// Fingers whose sums are not affine: hold, p_x, p_y, row_x, row_y, and what closing has left.
template <class Real>
struct FadedSums {
  unsigned lanes = 0;  ///< bit l: lane l
  Real* sums;          ///< [step][kTurnSums][width]
  Real* open_share;    ///< [step][width]
};

/// The joints of a bundle.
template <class Real>
struct FingerOutput {
  Real* q;         ///< [step][width] solver units, before anything closes
  Real* at_limit;  ///< [step][width] 1 where the fit was held at a limit, else 0
};

template <class Real>
struct FingerLanes {
  int width;
  void (*walk)(const AffineBundle<Real>& bundle, const FingerInput<Real>& input, const FadedSums<Real>& faded,
               const FingerOutput<Real>& output);
  PointMoments<Real> (*visit)(const PointColumns<Real>& columns, const RadialProfile<Real>& profile,
                              CascadeClosing closing);
  SquaredErrors (*squared_errors)(const PointColumns<Real>& columns, const RadialProfile<Real>& profile,
                                  CascadeClosing closing, const RigidTransform<Real>& T);
};

template <class Real>
FingerLanes<Real> finger_lanes_baseline();
template <class Real>
FingerLanes<Real> finger_lanes_avx2();  ///< call it only where AVX2 is

}  // namespace uhas
