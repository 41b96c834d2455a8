// Lanes: N numbers that every operation treats alike, so that one kernel solves N hands at once.
//
// A kernel is a template over its number type: with float or double it is the scalar code, with Lanes the same source
// works on one hand a lane. Hence every function below exists for plain numbers too; their comparisons give bool, those
// of Lanes a LaneMask, and what would be a branch is a `select`.
//
// `Tag` is a type in an unnamed namespace of the source file that instantiates a kernel. It gives all of that
// kernel's code internal linkage: what has been compiled for one instruction set cannot be linked into code that
// runs without it.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace uhas {

/// What a comparison of Lanes says: one truth a lane.
template <class Real, int N, class Tag>
struct LaneMask {
  typedef Real Numbers __attribute__((vector_size(N * sizeof(Real))));
  typedef long long Words __attribute__((vector_size(N * sizeof(Real))));
  using Bits = decltype(Numbers{} < Numbers{});  // 0 or ~0 in each lane

  constexpr LaneMask(bool all = false) : bits(all ? ~Bits{} : Bits{}) {}
  constexpr explicit LaneMask(Bits b) : bits(b) {}

  friend constexpr LaneMask operator&(LaneMask a, LaneMask b) { return LaneMask(a.bits & b.bits); }
  friend constexpr LaneMask operator|(LaneMask a, LaneMask b) { return LaneMask(a.bits | b.bits); }
  friend constexpr LaneMask operator!(LaneMask a) { return LaneMask(~a.bits); }

  Bits bits;
};

template <class Real, int N, class Tag>
struct Lanes {
  using Mask = LaneMask<Real, N, Tag>;
  using Vector = typename Mask::Numbers;

  Lanes() = default;  // not set, like a plain number
  constexpr Lanes(Real all) : v(all - Vector{}) {}
  constexpr explicit Lanes(Vector vector) : v(vector) {}

  friend constexpr Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend constexpr Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend constexpr Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
  friend constexpr Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
  friend constexpr Lanes operator-(Lanes a) { return Lanes(-a.v); }
  constexpr Lanes& operator+=(Lanes b) { return *this = *this + b; }
  constexpr Lanes& operator-=(Lanes b) { return *this = *this - b; }
  constexpr Lanes& operator*=(Lanes b) { return *this = *this * b; }

  friend constexpr Mask operator<(Lanes a, Lanes b) { return Mask(a.v < b.v); }
  friend constexpr Mask operator<=(Lanes a, Lanes b) { return Mask(a.v <= b.v); }
  friend constexpr Mask operator>(Lanes a, Lanes b) { return Mask(a.v > b.v); }
  friend constexpr Mask operator>=(Lanes a, Lanes b) { return Mask(a.v >= b.v); }
  friend constexpr Mask operator==(Lanes a, Lanes b) { return Mask(a.v == b.v); }
  friend constexpr Mask operator!=(Lanes a, Lanes b) { return Mask(a.v != b.v); }

  Vector v;
};

/// Number of lanes, type of one lane, and type of a comparison, of Lanes and of plain numbers.
template <class Num>
struct LaneTraits {
  using Real = Num;
  using Mask = bool;
  static constexpr int width = 1;
};
template <class R, int N, class Tag>
struct LaneTraits<Lanes<R, N, Tag>> {
  using Real = R;
  using Mask = LaneMask<R, N, Tag>;
  static constexpr int width = N;
};
template <class Num>
using LaneReal = typename LaneTraits<Num>::Real;
template <class Num>
using MaskOf = typename LaneTraits<Num>::Mask;

/// `a` where `mask` is true, else `b`. Both are evaluated.
template <class Real>
Real select(bool mask, Real a, Real b) {
  return mask ? a : b;
}
template <class Real, int N, class Tag>
Lanes<Real, N, Tag> select(LaneMask<Real, N, Tag> mask, Lanes<Real, N, Tag> a, Lanes<Real, N, Tag> b) {
  return Lanes<Real, N, Tag>(mask.bits ? a.v : b.v);
}

inline bool any(bool mask) { return mask; }
inline bool all(bool mask) { return mask; }
template <class Real, int N, class Tag>
bool any(LaneMask<Real, N, Tag> mask) {
  using Words = typename LaneMask<Real, N, Tag>::Words;
  Words words = (Words)mask.bits;
  long long joined = 0;
  for (std::size_t i = 0; i < sizeof(Words) / sizeof(long long); ++i) joined |= words[i];
  return joined != 0;
}
template <class Real, int N, class Tag>
bool all(LaneMask<Real, N, Tag> mask) {
  return !any(!mask);
}

/// The bits of each number, as an integer of its size.
inline std::int32_t bits(float a) { return std::bit_cast<std::int32_t>(a); }
inline std::int64_t bits(double a) { return std::bit_cast<std::int64_t>(a); }
template <class Real, int N, class Tag>
typename LaneMask<Real, N, Tag>::Bits bits(Lanes<Real, N, Tag> a) {
  return (typename LaneMask<Real, N, Tag>::Bits)a.v;
}

/// Whether such integers are other than 0.
template <class Num, class Integers>
MaskOf<Num> nonzero(Integers a) {
  return MaskOf<Num>(a != 0);
}

/// One lane, read and written.
template <class Real>
Real lane(const Real& a, int) {
  return a;
}
template <class Real, int N, class Tag>
Real lane(const Lanes<Real, N, Tag>& a, int i) {
  return a.v[i];
}
template <class Real, int N, class Tag>
bool lane(const LaneMask<Real, N, Tag>& a, int i) {
  return a.bits[i] != 0;
}
template <class Real>
void set_lane(Real& a, int, Real value) {
  a = value;
}
template <class Real, int N, class Tag>
void set_lane(Lanes<Real, N, Tag>& a, int i, Real value) {
  a.v[i] = value;
}

/// Consecutive numbers in memory, one a lane; no alignment is asked for.
template <class Num>
Num load(const LaneReal<Num>* from) {
  Num a;
  if constexpr (LaneTraits<Num>::width == 1)
    a = *from;
  else
    __builtin_memcpy(&a.v, from, sizeof a.v);
  return a;
}
template <class Real>
void store(const Real& a, Real* to) {
  *to = a;
}
template <class Real, int N, class Tag>
void store(const Lanes<Real, N, Tag>& a, Real* to) {
  __builtin_memcpy(to, &a.v, sizeof a.v);
}

template <class Num>
Num min(Num a, Num b) {
  return select(b < a, b, a);
}
template <class Num>
Num max(Num a, Num b) {
  return select(a < b, b, a);
}
template <class Num>
Num clamp(Num a, Num lower, Num upper) {
  return min(max(a, lower), upper);
}
template <class Num>
Num abs(Num a) {
  return select(a < Num(0), -a, a);
}

inline float sqrt(float a) { return std::sqrt(a); }
inline double sqrt(double a) { return std::sqrt(a); }
template <class Real, int N, class Tag>
Lanes<Real, N, Tag> sqrt(Lanes<Real, N, Tag> a) {
  Lanes<Real, N, Tag> root;
  for (int i = 0; i < N; ++i) root.v[i] = std::sqrt(a.v[i]);
  return root;
}

/// The sum of `Count` lanes from `First`, `Step` apart; each half of them onto the other, as narrower lanes would have
/// summed them.
template <int First, int Step, int Count, class Real, int N, class Tag>
Real sum_of_lanes(const Lanes<Real, N, Tag>& a) {
  if constexpr (Count == 1)
    return a.v[First];
  else
    return sum_of_lanes<First, 2 * Step, Count / 2>(a) + sum_of_lanes<First + Step, 2 * Step, Count / 2>(a);
}

/// The sum of all lanes.
template <class Real>
Real sum(const Real& a) {
  return a;
}
template <class Real, int N, class Tag>
Real sum(const Lanes<Real, N, Tag>& a) {
  return sum_of_lanes<0, 1, N>(a);
}

}  // namespace uhas
