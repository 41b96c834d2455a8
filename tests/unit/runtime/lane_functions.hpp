// The functions of lanes over whole arrays, compiled once for each instruction set, behind a boundary
// of plain pointers.
#pragma once

#include "uhas/runtime/instruction_set.hpp"

namespace uhas::test {

/// Every array has `count` numbers, a multiple of `width`.
template <class Real>
struct LaneFunctions {
  int width;
  void (*sincos)(const Real* x, int count, Real* sine, Real* cosine);
  void (*atan2)(const Real* y, const Real* x, int count, Real* angle);
  /// out_k: a + b, a - b, a * b, a / b, -a, min, max, clamp(a, 0, b), abs a, sqrt |a|, a < b ? a : 7, (a <= b) & !(a ==
  /// b) ? a : 7, (a > b) | (b != b) ? a : 7, the sum of all lanes of a, 1 if any lane a >= b, 1 if all lanes a >= b
  void (*operations)(const Real* a, const Real* b, int count, Real* const* out);
};
inline constexpr int kLaneOperations = 16;

template <class Real>
LaneFunctions<Real> lane_functions_baseline();
template <class Real>
LaneFunctions<Real> lane_functions_avx2();

}  // namespace uhas::test
