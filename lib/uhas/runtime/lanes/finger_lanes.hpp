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

/// Calls `use` on each, in their order.
template <class Sums, class Use>
void each_number(Sums& sums, Use use) {
  use(sums.hold), use(sums.p_x), use(sums.p_y);
  use(sums.row_x.x), use(sums.row_x.y), use(sums.row_x.z);
  use(sums.row_y.x), use(sums.row_y.y), use(sums.row_y.z);
}

/// The memory of a walk, a number a lane.
template <class Real>
struct FingerMemory {
  Real* sums;        ///< [step][kTurnSums][width]
  Real* open_share;  ///< [step][width] what closing has left of the weight that a joint carries
  Real* q;           ///< [step][width] solver units, before anything closes
  Real* at_limit;    ///< [step][width] 1 where the fit was held at a limit, else 0
};

template <class Real>
struct FingerLanes {
  using Walk = void (*)(const AffineBundle<Real>& bundle, const FingerInput<Real>& input,
                        const FingerMemory<Real>& memory);

  int width;
  Walk walk_whole;   ///< all fingers are whole: sets q and at_limit
  Walk affine_sums;  ///< sets the sums and open shares that fingers have if they are whole
  Walk walk_sums;    ///< from these, or others in their place, to q and at_limit
  PointMoments<Real> (*visit)(const PointColumns<Real>& columns, const RadialProfile<Real>& profile,
                              CascadeClosing closing);
  SquaredErrors (*squared_errors)(const PointColumns<Real>& columns, const RadialProfile<Real>& profile,
                                  CascadeClosing closing, const RigidTransform<Real>& T);
};

template <class Real>
FingerLanes<Real> finger_lanes_baseline();
template <class Real>
FingerLanes<Real> finger_lanes_avx2();  ///< call it only where AVX2 is
template <class Real>
FingerLanes<Real> finger_lanes_avx512();  ///< call it only where AVX2 and AVX-512 F, VL and DQ are

}  // namespace uhas
