// The cascade behind a boundary of plain pointers, so that each instruction set can have a compilation of its own.
#pragma once

#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {

/// Hands that one call solves at most.
inline constexpr int kMostLanes = 8;

/// Up to `width` actions for one hand that have passed ActionDecoder::check. A row is one action's numbers.
template <class Real>
struct ActionRows {
  const Real* values[kMostLanes];           ///< [width][5 + 5 V]; rows past `count` repeat one of the others
  const Real* phi[kMostLanes];              ///< [width][angles]
  const Real* azimuth_offsets[kMostLanes];  ///< [width][5], or all null
  const Real* radial_bounds[kMostLanes];    ///< [width][2], or all null
  Real* q[kMostLanes];                      ///< [count][joints] out
  int count;
  int vectors;      ///< V
  int angles;       ///< 0, V or 5 V
  bool common_phi;  ///< all rows share `phi`
  bool normalized;
};

/// `make` returns the scratch memory of one thread for one hand, whose model must outlive it. `take` solves rows, or what it
/// can of them: what waits for more rows of the same batch, `finish` ends. Both write no more than that memory and rows' q.
template <class Real>
struct CascadeLanes {
  int width;
  void* (*make)(const SolverModel<Real>& model);
  void (*destroy)(void* scratch);
  void (*take)(void* scratch, const ActionRows<Real>& rows);
  void (*finish)(void* scratch);
};

template <class Real>
CascadeLanes<Real> cascade_lanes_scalar();  ///< every option; one hand at a time
template <class Real>
CascadeLanes<Real> cascade_lanes_baseline();  ///< CascadeRule::correspondence and FieldReading::finger only
template <class Real>
CascadeLanes<Real> cascade_lanes_avx2();  ///< the same; call it only where AVX2 and FMA are

}  // namespace uhas
