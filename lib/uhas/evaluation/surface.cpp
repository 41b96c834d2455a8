#include "uhas/evaluation/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/base/spherical.hpp"
#include "uhas/evaluation/least_squares/driving_plane.hpp"
#include "uhas/evaluation/parallel.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {
namespace {

constexpr double kPi = std::numbers::pi;

/// Indices of each finger's own correspondences; a point on a joint that several fingers share is the first one's.
std::vector<std::vector<int>> points_by_finger(const HandProfile& profile) {
  std::vector<std::vector<int>> points(profile.fingers.size());
  for (int k = 0; k < static_cast<int>(profile.correspondences.size()); ++k) {
    const int joint = profile.links[profile.correspondences[k].link].joint;
    const auto finger = std::ranges::find_if(
        profile.fingers, [&](const ProfileFinger& f) { return std::ranges::find(f.joints, joint) != f.joints.end(); });
    if (joint >= 0 && finger != profile.fingers.end()) points[finger - profile.fingers.begin()].push_back(k);
  }
  return points;
}

/// [finger] distances of its points from the sphere that `action` deforms.
std::vector<std::vector<double>> distances(const HandProfile& profile, const std::vector<std::vector<int>>& points,
                                           CascadeSolver<double>& solver, std::span<const double> action) {
  const ActionSpace space(profile);
  const RigidTransformd T_sphere_palm = profile.T_palm_sphere.inverse();
  std::vector<double> q(profile.tree.joints.size());
  std::vector<RigidTransformd> T_palm_joint(q.size());
  solver.solve({.values = action}, q);
  forward_kinematics(profile.tree, q, T_palm_joint);
  std::vector<std::vector<double>> result(points.size());
  for (std::size_t f = 0; f < points.size(); ++f) {
    const DrivingPlane plane = driving_plane(profile.fingers[f], space, action);
    for (int k : points[f]) {
      const Correspondence& c = profile.correspondences[k];
      const ProfileLink& link = profile.links[c.link];
      const Spherical<double> s =
          to_spherical(T_sphere_palm * (T_palm_joint[link.joint] * (link.T_joint_link * c.p_link)));
      const double radius = 1 + plane.at(s.polar);
      if (radius >= 0) result[f].push_back(std::abs(s.radius / profile.radius - radius));
    }
  }
  return result;
}

/// The widest stretch between neighbouring polar angles.
void find_gap(const HandProfile& profile, const std::vector<int>& points, FingerSurface& finger) {
  std::vector<double> phi;
  for (int k : points) phi.push_back(profile.correspondences[k].phi);
  if (phi.empty()) return;
  std::ranges::sort(phi);
  finger.phi_least = phi.front(), finger.phi_greatest = phi.back();
  for (std::size_t k = 1; k < phi.size(); ++k) finger.phi_gap = std::max(finger.phi_gap, phi[k] - phi[k - 1]);
}

/// Rings of equal height in cos(phi), hence of equal area, each cut into cells of equal azimuth.
void find_coverage(const HandProfile& profile, SurfaceScore& score) {
  constexpr int rings = 6, sectors = 40;  // of the hemisphere: 2 pi / 240 each, the area of a square of 9.3 degrees
  std::vector<bool> held(rings * sectors);
  std::vector<Vector3d> directions;
  for (const Correspondence& c : profile.correspondences) {
    directions.push_back(from_spherical<double>({c.theta, c.phi, 1.0}));
    const int ring = static_cast<int>((1 - std::cos(c.phi)) * rings);
    const int sector = std::min(static_cast<int>((c.theta + kPi) / (2 * kPi) * sectors), sectors - 1);
    if (ring < rings) held[ring * sectors + sector] = true;
  }
  score.coverage = static_cast<double>(std::ranges::count(held, true)) / static_cast<double>(held.size());
  double least_cosine = 1;
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const double phi = std::acos(1 - (ring + 0.5) / rings), theta = 2 * kPi * (sector + 0.5) / sectors - kPi;
      const Vector3d middle = from_spherical<double>({theta, phi, 1.0});
      double nearest = -1;
      for (const Vector3d& d : directions) nearest = std::max(nearest, dot(d, middle));
      least_cosine = std::min(least_cosine, nearest);
    }
  score.largest_hole = std::acos(least_cosine);
}

}  // namespace

SurfaceScore measure_surface(const HandProfile& profile, std::span<const std::vector<double>> battery, int threads) {
  const std::vector<std::vector<int>> points = points_by_finger(profile);
  const CascadeSolver<double> solver(profile);
  std::vector<std::vector<std::vector<double>>> found(battery.size());
  parallel_for(static_cast<int>(battery.size()), threads, [&] {
    return [&, own = solver](int n) mutable { found[n] = distances(profile, points, own, battery[n]); };
  });
  CascadeSolver<double> own = solver;
  const std::vector<std::vector<double>> rest = distances(profile, points, own, ActionSpace(profile).zero());

  SurfaceScore score;
  std::vector<double> all_rest, all_deformed;
  for (std::size_t f = 0; f < points.size(); ++f) {
    std::vector<double> deformed;
    for (const auto& row : found) deformed.insert(deformed.end(), row[f].begin(), row[f].end());
    FingerSurface& finger = score.fingers.emplace_back();
    finger.at_rest = quantiles(rest[f]);
    finger.deformed = quantiles(deformed);
    find_gap(profile, points[f], finger);
    all_rest.insert(all_rest.end(), rest[f].begin(), rest[f].end());
    all_deformed.insert(all_deformed.end(), deformed.begin(), deformed.end());
  }
  score.at_rest = quantiles(std::move(all_rest));
  score.deformed = quantiles(std::move(all_deformed));
  find_coverage(profile, score);
  return score;
}

}  // namespace uhas
