// The moments of a patch under the deformation of its finger's plane, before the azimuth turns
// (docs/method.md#sums-of-a-patch).
//
// Whether a patch stays whole, has vanished or fades in between is decided by its range of polar angles. A whole
// patch needs no look at its points, one that has vanished has no moments; only a fading patch is visited, several
// points at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "uhas/runtime/cascade/plane_deformation.hpp"
#include "uhas/runtime/cascade/surface_patches.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// Where fading begins and ends (displacements, radii; docs/method.md#closing); `hard` drops at the end and fades
/// nowhere.
inline constexpr double kFadeBegins = -0.5, kFadeEnds = -1.0;

/// What closing leaves of a point: 1 or 0 for `hard`, else smoothstep between the bounds above. At the anchored pole
/// the displacement of the first driving vector counts for `fade`: it must not keep a root open.
template <class Num>
Num open_share(const typename RadialProfile<Num>::At& radial, CascadeClosing closing) {
  // hard: by the sign of the sphere's radius at the point itself
  if (closing == CascadeClosing::hard) return select(Num(1) + radial.delta_r < Num(0), Num(0), Num(1));
  // fade: smoothstep of u, the radius at the point or at the first driving vector, in halves
  const Num u = clamp((Num(1) + radial.past_first) * Num(2), Num(0), Num(1));
  return u * u * (Num(3) - Num(2) * u);
}

/// A surface point, or as many as Num has lanes.
template <class Num>
struct PointNumbers {
  Num phi, rho, weight;
  Vector3<Num> p, direction;
};

/// Sums over `count` points under a deformation, each with what closing has left of it; the full weight stays 0.
/// @tparam Num      numbers of one point and one hand, of a point a lane or of a hand a lane
/// @param point_at  point_at(k): PointNumbers
template <class Num, class PointAt>
PointMoments<Num> visit_points(std::size_t count, const PointAt& point_at, const RadialProfile<Num>& profile,
                               CascadeClosing closing) {
  PointMoments<Num> moments;
  // in three rounds a block of points: registers do not hold all the sums at once
  constexpr std::size_t block = 32;
  std::array<Num, block> shares, targets;
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t length = std::min(block, count - first);
    // what is left of a point at its polar angle; its target goes out along the direction, not behind the centre
    with_constant(profile.vectors, [&](auto vectors) {
      for (std::size_t k = 0; k < length; ++k) {
        const PointNumbers<Num> point = point_at(first + k);
        const auto radial = profile.at(point.phi, vectors);
        shares[k] = point.weight * open_share<Num>(radial, closing);
        targets[k] = shares[k] * max(point.rho + radial.delta_r, Num(0));
      }
    });
    // W, P and T of docs/method.md#moments
    for (std::size_t k = 0; k < length; ++k) {
      const PointNumbers<Num> point = point_at(first + k);
      moments.weight += shares[k];
      moments.p += shares[k] * point.p;
      moments.t += targets[k] * point.direction;
    }
    // M
    for (std::size_t k = 0; k < length; ++k) {
      const PointNumbers<Num> point = point_at(first + k);
      const Vector3<Num> target = targets[k] * point.direction;
      moments.pt[0] += target.x * point.p;
      moments.pt[1] += target.y * point.p;
      moments.pt[2] += target.z * point.p;
    }
  }
  return moments;
}

/// Moments of a patch, one point after the other.
struct VisitInTurn {
  template <class Num>
  PointMoments<Num> operator()(const PointColumns<LaneReal<Num>>& columns, const RadialProfile<Num>& profile,
                               CascadeClosing closing) const {
    const auto point_at = [&](std::size_t k) {
      const auto vector = [&](const auto& v) { return Vector3<Num>{Num(v[0][k]), Num(v[1][k]), Num(v[2][k])}; };
      return PointNumbers<Num>{Num(columns.phi[k]), Num(columns.rho[k]), Num(columns.weight[k]), vector(columns.p),
                               vector(columns.direction)};
    };
    return visit_points<Num>(columns.count, point_at, profile, closing);
  }
};

/// Points of a patch side by side, `Wide` lanes of them at once, for one hand. Points a fixed stride apart go into one sum,
/// so that lanes of any width give the same bits.
template <class Wide>
class PointsSideBySide {
 public:
  using Real = LaneReal<Wide>;

  PointsSideBySide(const PointColumns<Real>& columns, const RadialProfile<Real>& profile) : columns_(columns) {
    profile_.vectors = profile.vectors;
    for (int j = 0; j < profile.vectors; ++j) {
      profile_.phi[j] = Wide(profile.phi[j]);
      profile_.delta_r[j] = Wide(profile.delta_r[j]);
      profile_.slope[j] = Wide(profile.slope[j]);
    }
  }

  /// Calls `visit(count, point_at, profile)` for each set of points that go into sums of their own.
  template <class Visit>
  void each_set(const Visit& visit) const {
    constexpr std::size_t width = LaneTraits<Wide>::width, stride = 32 / sizeof(Real);
    static_assert(width <= stride && PointColumns<Real>::kWidest % stride == 0);
    for (std::size_t first = 0; first < stride; first += width) {
      const auto point_at = [&](std::size_t k) {
        const auto column = [&](const auto& numbers) { return load<Wide>(numbers.data() + first + k * stride); };
        const auto vector = [&](const auto& v) { return Vector3<Wide>{column(v[0]), column(v[1]), column(v[2])}; };
        return PointNumbers<Wide>{column(columns_.phi), column(columns_.rho), column(columns_.weight),
                                  vector(columns_.p), vector(columns_.direction)};
      };
      visit(columns_.length / stride, point_at, profile_);
    }
  }

 private:
  const PointColumns<Real>& columns_;
  RadialProfile<Wide> profile_;
};

/// What VisitInTurn gives.
template <class Wide>
PointMoments<LaneReal<Wide>> visit_side_by_side(const PointColumns<LaneReal<Wide>>& columns,
                                                const RadialProfile<LaneReal<Wide>>& profile, CascadeClosing closing) {
  using Real = LaneReal<Wide>;
  PointMoments<Wide> all;
  PointsSideBySide<Wide>(columns, profile).each_set([&](std::size_t count, const auto& point_at, const auto& spread) {
    all.add(visit_points<Wide>(count, point_at, spread, closing));
  });
  const auto vector = [](const Vector3<Wide>& v) { return Vector3<Real>{sum(v.x), sum(v.y), sum(v.z)}; };
  PointMoments<Real> moments;
  moments.weight = sum(all.weight);
  moments.p = vector(all.p);
  moments.t = vector(all.t);
  for (int j = 0; j < 3; ++j) moments.pt[j] = vector(all.pt[j]);
  return moments;
}

/// Squared distances of points from their targets, each by its weight and what closing has left of it.
struct SquaredErrors {
  double sum = 0, weight = 0;  ///< sphere radii squared

  void add(const SquaredErrors& other) { sum += other.sum, weight += other.weight; }
  /// Root of the mean, sphere radii; NaN when closing has dropped every point.
  double rms() const { return weight > 0 ? std::sqrt(sum / weight) : std::numeric_limits<double>::quiet_NaN(); }
};

/// @param T  the moved frame of the points' joint, in axes in which no azimuth turns targets
template <class Wide>
SquaredErrors squared_errors(const PointColumns<LaneReal<Wide>>& columns, const RadialProfile<LaneReal<Wide>>& profile,
                             CascadeClosing closing, const RigidTransform<LaneReal<Wide>>& T) {
  const RigidTransform<Wide> frame = T.template cast<Wide>();
  Wide all(0), weight(0);
  PointsSideBySide<Wide>(columns, profile).each_set([&](std::size_t count, const auto& point_at, const auto& spread) {
    Wide set(0), set_weight(0);
    for (std::size_t k = 0; k < count; ++k) {
      const PointNumbers<Wide> point = point_at(k);
      const auto radial = spread.at(point.phi);
      const Wide share = point.weight * open_share<Wide>(radial, closing);
      const Vector3<Wide> error = frame * point.p - max(point.rho + radial.delta_r, Wide(0)) * point.direction;
      set += share * dot(error, error);
      set_weight += share;
    }
    all += set, weight += set_weight;
  });
  return {double(sum(all)), double(sum(weight))};
}

/// Which lanes' points are all whole with targets in front of the centre, and which lanes' have all vanished.
template <class Num>
struct PatchState {
  MaskOf<Num> whole, vanished;
};

/// By the least and the greatest displacement over the patch's range of polar angles, without a look at its points.
template <class Num>
PatchState<Num> classify_patch(const SolverPatch<LaneReal<Num>>& patch, const PlaneDeformation<Num>& plane,
                               CascadeClosing closing) {
  using Real = LaneReal<Num>;
  const Num least_phi(patch.least_phi), greatest_phi(patch.greatest_phi);
  // whether sums may stand for the points. Sums of great differences lose digits: driving vectors a few degrees apart
  // are left to the points. Sums are looked up at one angle for all lanes: vectors apart must not stand in the patch
  constexpr Real steep = 50;
  MaskOf<Num> summable = plane.steepest <= Num(steep);
  if (!plane.common_angles)
    for (int j = 0; j < plane.vectors; ++j)
      summable = summable & ((plane.phi[j] <= least_phi) | (plane.phi[j] >= greatest_phi));
  // no vector so low that anything fades or passes the centre: the patch is whole (most are)
  if (all(plane.lowest >= Num(std::max(Real(kFadeBegins), -patch.least_rho)))) return {summable, MaskOf<Num>(false)};

  // the extremes of a piecewise linear displacement: at the ends of the range and at driving vectors inside
  const auto first = plane.at(least_phi), last = plane.at(greatest_phi);
  Num lowest = min(first.delta_r, last.delta_r), highest = max(first.delta_r, last.delta_r);
  Num lowest_past = min(first.past_first, last.past_first), highest_past = max(first.past_first, last.past_first);
  for (int j = 0; j < plane.vectors; ++j) {
    const MaskOf<Num> inside = (plane.phi[j] > least_phi) & (plane.phi[j] < greatest_phi);
    lowest = select(inside, min(lowest, plane.delta_r[j]), lowest);
    highest = select(inside, max(highest, plane.delta_r[j]), highest);
    lowest_past = select(inside, min(lowest_past, plane.delta_r[j]), lowest_past);
    highest_past = select(inside, max(highest_past, plane.delta_r[j]), highest_past);
  }
  // whole: targets in front of the centre and no point faded; vanished: every point gone
  const Num begins{Real(kFadeBegins)}, ends{Real(kFadeEnds)};
  const bool hard = closing == CascadeClosing::hard;
  const MaskOf<Num> in_front = Num(patch.least_rho) + lowest >= Num(0);
  const MaskOf<Num> shown = hard ? lowest >= ends : lowest_past >= begins;
  const MaskOf<Num> whole = summable & in_front & shown;
  return {whole, hard ? highest < ends : highest_past <= ends};
}

/// Moments of all points, whole, into `moments`: targets are those at rest, and on each stretch between driving vectors
/// (offset + slope phi) direction more.
template <class Num>
void sum_whole(const SolverPatch<LaneReal<Num>>& patch, const PlaneDeformation<Num>& plane,
               PointMoments<Num>& moments) {
  using Real = LaneReal<Num>;
  // on the stretch where the patch begins, delta r = offset + slope phi
  Num slope = plane.slope[0], offset = plane.delta_r[0] - plane.slope[0] * plane.phi[0];
  for (int j = 0; j < plane.vectors; ++j) {
    const MaskOf<Num> passed = plane.phi[j] <= Num(patch.least_phi);
    slope = select(passed, plane.slope_past(j), slope);
    offset = select(passed, plane.delta_r[j] - plane.slope_past(j) * plane.phi[j], offset);
  }
  // so much of the sums over all points
  struct Term {
    const TargetMoments<Real>* sums;
    Num factor;
  };
  Term terms[2 + 2 * kMaxDrivingVectors];
  terms[0] = {&patch.beyond_phi.front(), slope};
  terms[1] = {&patch.beyond.front(), offset};
  int count = 2;
  // driving vectors inside the patch: the slope changes by c there, which adds c (phi - phi_j) to the points beyond
  for (int j = 0; j < plane.vectors && plane.common_angles; ++j) {
    const Real phi = lane(plane.phi[j], 0);
    if (!(phi > patch.least_phi && phi < patch.greatest_phi)) continue;
    std::size_t k = 0;  // the first point beyond
    while (patch.columns.phi[k] <= phi) ++k;
    const Num change = plane.slope_past(j) - plane.slope[j];
    terms[count++] = {&patch.beyond_phi[k], change};
    terms[count++] = {&patch.beyond[k], -phi * change};
  }

  // the terms added to the sums at rest
  const auto sum = [&](auto part) {
    Vector3<Num> total = part(patch.rest).template cast<Num>();
    for (int n = 0; n < count; ++n) total += terms[n].factor * part(*terms[n].sums).template cast<Num>();
    return total;
  };
  moments.full_weight = moments.weight = Num(patch.rest.full_weight);
  moments.p = patch.rest.p.template cast<Num>();
  moments.t = sum([](const TargetMoments<Real>& sums) { return sums.t; });
  moments.pt[0] = sum([](const TargetMoments<Real>& sums) { return sums.pt[0]; });
  moments.pt[1] = sum([](const TargetMoments<Real>& sums) { return sums.pt[1]; });
  moments.pt[2] = sum([](const TargetMoments<Real>& sums) { return sums.pt[2]; });
}

/// 0 in the lanes where `mask` is false; the full weight stays.
template <class Num>
void keep_where(MaskOf<Num> mask, PointMoments<Num>& moments) {
  const auto keep = [&](Num& number) { number = select(mask, number, Num(0)); };
  const auto keep_vector = [&](Vector3<Num>& vector) { keep(vector.x), keep(vector.y), keep(vector.z); };
  keep(moments.weight);
  keep_vector(moments.p);
  keep_vector(moments.t);
  for (Vector3<Num>& column : moments.pt) keep_vector(column);
}

/// Moments of a patch, lane by lane as its plane deforms it, into `moments`.
/// @param visit  visit(columns, profile, closing): the moments point by point
template <class Num, class Visit>
void sum_patch(const SolverPatch<LaneReal<Num>>& patch, const PlaneDeformation<Num>& plane, CascadeClosing closing,
               const Visit& visit, PointMoments<Num>& moments) {
  const PatchState<Num> state = classify_patch(patch, plane, closing);
  // lanes where the patch is whole: by sums; nothing in the others so far
  if (any(state.whole)) {
    sum_whole(patch, plane, moments);
    if (all(state.whole)) return;
    keep_where<Num>(state.whole, moments);
  } else {
    moments = {};
    moments.full_weight = Num(patch.rest.full_weight);
  }
  // lanes where it fades: point by point
  const MaskOf<Num> fades = !(state.whole | state.vanished);
  if (!any(fades)) return;
  PointMoments<Num> visited = visit(patch.columns, plane, closing);
  if (!all(fades)) keep_where<Num>(fades, visited);
  moments.add(visited);
}

}  // namespace uhas
