// Between arrays of hands, one row of numbers a hand, and Lanes, one hand a lane.
#pragma once

#include <cstddef>
#include <utility>

#include "uhas/runtime/lanes/lanes.hpp"

namespace uhas {

/// The numbers that wide kernels take: nothing infinite, no NaN, no angle beyond what `sincos` is exact for.
template <class Num>
struct LaneNumbers {
  using Real = LaneReal<Num>;
  static constexpr std::size_t width = LaneTraits<Num>::width;

  static bool takes(const Real* numbers, std::size_t count) {
    const Num bound(Real(1000));
    MaskOf<Num> fine(true);
    std::size_t i = 0;
    for (; i + width <= count; i += width) fine = fine & (abs(load<Num>(numbers + i)) <= bound);
    if (!all(fine)) return false;
    for (; i < count; ++i)
      if (!(abs(numbers[i]) <= Real(1000))) return false;
    return true;
  }
};

/// Turns rows into columns: lane j of rows[i] becomes lane i of rows[j]. Loops are unrolled so that the rows
/// stay in registers.
template <class Real, int N, class Tag>
struct LaneTranspose {
  using Vector = typename Lanes<Real, N, Tag>::Vector;

  /// Lanes of `a` whose index has not the bit `step`, each followed, `step` further on, by the same lane of `b`; with
  /// `upper` the lanes that have it.
  template <int step, bool upper, std::size_t... i>
  static Vector merge(Vector a, Vector b, std::index_sequence<i...>) {
    return __builtin_shufflevector(a, b,
                                   ((i & step) ? int(i) - (upper ? 0 : step) + N : int(i) + (upper ? step : 0))...);
  }

  // blocks of step x step numbers change places across the diagonal, for step = N/2, N/4 .. 1
  template <int step = N / 2>
  static void apply(Vector (&rows)[N]) {
    if constexpr (step > 0) {
#pragma GCC unroll 8
      for (int i = 0; i < N; ++i) {
        if (i & step) continue;
        const Vector a = rows[i], b = rows[i + step];
        rows[i] = merge<step, false>(a, b, std::make_index_sequence<N>());
        rows[i + step] = merge<step, true>(a, b, std::make_index_sequence<N>());
      }
      apply<step / 2>(rows);
    }
  }
};

/// columns[j] gets number j of each row, a row a lane; lanes beyond `filled` repeat the last row.
/// @param rows  `filled` (1 to the number of lanes) rows of `numbers` numbers, `stride` apart
template <class Real, int N, class Tag>
void load_rows(const Real* rows, std::size_t stride, std::size_t filled, std::size_t numbers,
               Lanes<Real, N, Tag>* columns) {
  const auto row = [&](std::size_t i) { return rows + (i < filled ? i : filled - 1) * stride; };
  if (numbers < N) {
    for (std::size_t j = 0; j < numbers; ++j)
      for (int i = 0; i < N; ++i) columns[j].v[i] = row(i)[j];
    return;
  }
  for (std::size_t j = 0; j < numbers; j += N) {
    const std::size_t first = j + N <= numbers ? j : numbers - N;  // the last block overlaps the one before
    typename LaneTranspose<Real, N, Tag>::Vector block[N];
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) block[i] = load<Lanes<Real, N, Tag>>(row(i) + first).v;
    LaneTranspose<Real, N, Tag>::apply(block);
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) columns[first + i].v = block[i];
  }
}

/// The way back: the first `filled` lanes of columns[j] become number j of as many rows.
template <class Real, int N, class Tag>
void store_rows(const Lanes<Real, N, Tag>* columns, std::size_t filled, std::size_t numbers, std::size_t stride,
                Real* rows) {
  if (numbers < N) {
    for (std::size_t j = 0; j < numbers; ++j)
      for (std::size_t i = 0; i < filled; ++i) rows[i * stride + j] = columns[j].v[i];
    return;
  }
  for (std::size_t j = 0; j < numbers; j += N) {
    const std::size_t first = j + N <= numbers ? j : numbers - N;
    typename LaneTranspose<Real, N, Tag>::Vector block[N];
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) block[i] = columns[first + i].v;
    LaneTranspose<Real, N, Tag>::apply(block);
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i)
      if (std::size_t(i) < filled) store(Lanes<Real, N, Tag>(block[i]), rows + i * stride + first);
  }
}

}  // namespace uhas
