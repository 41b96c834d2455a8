#include "uhas/runtime/cascade/surface_patches.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "uhas/base/spherical.hpp"
#include "uhas/runtime/cascade/solver_frame.hpp"

namespace uhas {
namespace {

/// The finger whose plane a point follows: of those that share the joint, the one nearest in azimuth; -1 for none.
int finger_of_point(const HandProfile& profile, const Correspondence& c) {
  int nearest = -1;
  const auto distance = [&](int f) { return std::abs(wrap_angle(c.theta - profile.fingers[f].theta_initial)); };
  for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f) {
    const std::vector<int>& joints = profile.fingers[f].joints;
    if (std::find(joints.begin(), joints.end(), profile.links[c.link].joint) == joints.end()) continue;
    if (nearest < 0 || distance(f) < distance(nearest)) nearest = f;
  }
  return nearest;
}

template <class Real>
SolverPoint<Real> compile_point(const HandProfile& profile, const PlaneGroups& groups, const Correspondence& c,
                                int finger) {
  const ProfileLink& link = profile.links[c.link];
  const double azimuth = profile.mirrored ? -c.theta : c.theta;
  const BetweenPlanes place = locate_between_planes(c.theta, groups.azimuths);
  return {.joint = link.joint,
          .finger = finger,
          .p = point_in_solver(profile, link, c.p_link).cast<Real>(),
          .direction = from_spherical<double>({azimuth, c.phi, 1.0}).cast<Real>(),
          .rho = static_cast<Real>(c.rho),
          .phi = static_cast<Real>(c.phi),
          .weight = static_cast<Real>(c.weight),
          .plane_before = place.before,
          .plane_after = place.after,
          .blend = static_cast<Real>(place.blend)};
}

template <class Real>
PointColumns<Real> columns_of(std::span<const SolverPoint<Real>> points) {
  PointColumns<Real> columns;
  constexpr std::size_t widest = PointColumns<Real>::kWidest;
  columns.count = points.size();
  columns.length = (points.size() + widest - 1) / widest * widest;
  const auto fill = [&](std::vector<Real>& column, const auto& number) {
    for (const SolverPoint<Real>& point : points) column.push_back(number(point));
    column.resize(columns.length);
  };
  using Point = SolverPoint<Real>;
  fill(columns.phi, [](const Point& point) { return point.phi; });
  fill(columns.rho, [](const Point& point) { return point.rho; });
  fill(columns.weight, [](const Point& point) { return point.weight; });
  fill(columns.p[0], [](const Point& point) { return point.p.x; });
  fill(columns.p[1], [](const Point& point) { return point.p.y; });
  fill(columns.p[2], [](const Point& point) { return point.p.z; });
  fill(columns.direction[0], [](const Point& point) { return point.direction.x; });
  fill(columns.direction[1], [](const Point& point) { return point.direction.y; });
  fill(columns.direction[2], [](const Point& point) { return point.direction.z; });
  return columns;
}

/// Sums up the points of one patch, which are sorted by polar angle.
template <class Real>
SolverPatch<Real> compile_patch(std::span<const SolverPoint<Real>> points, bool first_of_joint) {
  SolverPatch<Real> patch{.joint = points.front().joint,
                          .finger = points.front().finger,
                          .first_of_joint = first_of_joint,
                          .least_phi = points.front().phi,
                          .greatest_phi = points.back().phi,
                          .least_rho = points.front().rho,
                          .rest = {},
                          .beyond = std::vector<TargetMoments<Real>>(points.size()),
                          .beyond_phi = std::vector<TargetMoments<Real>>(points.size()),
                          .columns = columns_of(points)};
  // from the last point to the first: the sums so far are those of this point and of all beyond it
  TargetMoments<Real> beyond, beyond_phi;
  for (std::size_t k = points.size(); k-- > 0;) {
    const SolverPoint<Real>& point = points[k];
    patch.least_rho = std::min(patch.least_rho, point.rho);
    patch.rest.add(point.weight, Real(1), point.p, point.rho * point.direction);
    beyond.add_pair(point.p, point.weight * point.direction);
    beyond_phi.add_pair(point.p, point.weight * point.phi * point.direction);
    patch.beyond[k] = beyond;
    patch.beyond_phi[k] = beyond_phi;
  }
  return patch;
}

}  // namespace

template <class Real>
std::vector<SolverPoint<Real>> compile_points(const HandProfile& profile, const PlaneGroups& groups) {
  std::vector<SolverPoint<Real>> points;
  for (const Correspondence& c : profile.correspondences) {
    const int finger = finger_of_point(profile, c);
    if (c.weight > 0 && finger >= 0) points.push_back(compile_point<Real>(profile, groups, c, finger));
  }
  std::stable_sort(points.begin(), points.end(), [](const SolverPoint<Real>& a, const SolverPoint<Real>& b) {
    return std::tuple(a.joint, a.finger, a.phi) < std::tuple(b.joint, b.finger, b.phi);
  });
  return points;
}

template <class Real>
std::vector<SolverPatch<Real>> compile_patches(const std::vector<SolverPoint<Real>>& points) {
  std::vector<SolverPatch<Real>> patches;
  for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
    while (last < points.size() && points[last].joint == points[first].joint &&
           points[last].finger == points[first].finger)
      ++last;
    const bool first_of_joint = patches.empty() || patches.back().joint != points[first].joint;
    patches.push_back(compile_patch(std::span(points).subspan(first, last - first), first_of_joint));
  }
  return patches;
}

template std::vector<SolverPoint<float>> compile_points<float>(const HandProfile&, const PlaneGroups&);
template std::vector<SolverPoint<double>> compile_points<double>(const HandProfile&, const PlaneGroups&);
template std::vector<SolverPatch<float>> compile_patches<float>(const std::vector<SolverPoint<float>>&);
template std::vector<SolverPatch<double>> compile_patches<double>(const std::vector<SolverPoint<double>>&);

}  // namespace uhas
