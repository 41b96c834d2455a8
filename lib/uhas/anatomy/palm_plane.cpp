#include "uhas/anatomy/palm_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/anatomy/fingers/finger_pose.hpp"
#include "uhas/base/spherical.hpp"

namespace uhas {
namespace {

/// Azimuths that differ by less are equal.
constexpr double kAzimuthTie = 5 * std::numbers::pi / 180;
/// A direction with less than this part in the palm plane does not tell where the finger is.
constexpr double kLeastInPlane = 0.2;

std::vector<double> azimuths(const PalmPlane& plane, const std::vector<Vector3d>& points) {
  std::vector<double> result;
  for (const Vector3d& p : points)
    result.push_back(std::atan2(dot(p - plane.center, plane.y), dot(p - plane.center, plane.x)));
  return result;
}

/// The finger with the widest gaps to its neighbours on both sides; the first of equals.
int most_separate_finger(const std::vector<double>& azimuth) {
  constexpr double turn = 2 * std::numbers::pi;
  int widest = 0;
  double widest_gap = -1;
  for (std::size_t i = 0; i < azimuth.size(); ++i) {
    double next = turn, previous = turn;
    for (std::size_t j = 0; j < azimuth.size(); ++j) {
      if (j == i) continue;
      const double ahead = std::fmod(azimuth[j] - azimuth[i] + 2 * turn, turn);
      next = std::min(next, ahead);
      previous = std::min(previous, turn - ahead);
    }
    if (next + previous > widest_gap + kAzimuthTie) {
      widest = static_cast<int>(i);
      widest_gap = next + previous;
    }
  }
  return widest;
}

/// In-plane direction of the middle finger, or of the fingers that stand against the thumb finger.
Vector3d forward_direction(const Anatomy& anatomy, const PalmPlane& plane) {
  const Vector3d n = anatomy.palm_normal_palm;
  Vector3d along, from_center;
  for (int i = 0; i < static_cast<int>(plane.roots.size()); ++i) {
    if (anatomy.middle >= 0 ? i != anatomy.middle : i == plane.thumb_finger) continue;
    along += normalized(plane.tips[i] - plane.roots[i]);
    from_center += plane.roots[i] - plane.center;
  }
  const Vector3d in_plane = orthogonal_part(normalized(along), n);
  if (norm(in_plane) >= kLeastInPlane) return normalized(in_plane);
  const Vector3d to_roots = normalized(orthogonal_part(from_center, n));
  return norm(to_roots) > 0 ? to_roots : any_orthogonal(n);
}

}  // namespace

PalmPlane measure_palm_plane(const Anatomy& anatomy) {
  PalmPlane plane;
  FingerPose pose;
  for (const FingerAnatomy& finger : anatomy.fingers) {
    pose_finger(anatomy, finger, anatomy.q_open, pose);
    plane.roots.push_back(pose.origin.front());
    plane.tips.push_back(pose.tip);
    plane.center += pose.origin.front() / static_cast<double>(anatomy.fingers.size());
  }
  const Vector3d n = anatomy.palm_normal_palm;
  plane.thumb_finger = anatomy.thumb;
  if (anatomy.thumb < 0) {  // gaps do not depend on where azimuth begins
    plane.x = any_orthogonal(n);
    plane.y = cross(n, plane.x);
    plane.thumb_finger = most_separate_finger(azimuths(plane, plane.tips));
  }
  plane.x = forward_direction(anatomy, plane);
  plane.y = cross(n, plane.x);
  plane.azimuth = azimuths(plane, plane.tips);
  return plane;
}

}  // namespace uhas
