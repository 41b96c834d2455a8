#include "uhas/anatomy/palm_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

/// In-plane direction of the middle finger, or of the fingers that stand against the thumb finger; where these hardly
/// lie in the plane, the way from the palm centre to their roots.
Vector3d forward_direction(const PalmPlane& plane, Vector3d n, int middle) {
  Vector3d along, from_center;
  for (int i = 0; i < static_cast<int>(plane.roots.size()); ++i) {
    if (middle >= 0 ? i != middle : i == plane.thumb_finger) continue;
    along += normalized(plane.tips[i] - plane.roots[i]);
    from_center += plane.roots[i] - plane.center;
  }
  const Vector3d in_plane = orthogonal_part(normalized(along), n);
  if (norm(in_plane) >= kLeastInPlane) return normalized(in_plane);
  const Vector3d to_roots = normalized(orthogonal_part(from_center, n));
  return norm(to_roots) > 0 ? to_roots : any_orthogonal(n);
}

}  // namespace

PalmPlane measure_palm_plane(std::vector<Vector3d> roots, std::vector<Vector3d> tips, Vector3d palm_normal, int thumb,
                             int middle) {
  PalmPlane plane;
  plane.roots = std::move(roots);
  plane.tips = std::move(tips);
  for (const Vector3d& root : plane.roots) plane.center += root / static_cast<double>(plane.roots.size());

  // what stands in for a missing thumb; gaps between fingers do not depend on where azimuth begins
  plane.thumb_finger = thumb;
  if (thumb < 0) {
    plane.x = any_orthogonal(palm_normal);
    plane.y = cross(palm_normal, plane.x);
    plane.thumb_finger = most_separate_finger(azimuths(plane, plane.tips));
  }

  plane.x = forward_direction(plane, palm_normal, middle);
  plane.y = cross(palm_normal, plane.x);
  plane.azimuth = azimuths(plane, plane.tips);
  return plane;
}

PalmPlane measure_palm_plane(const Anatomy& anatomy) {
  std::vector<Vector3d> roots, tips;
  for (const FingerAnatomy& finger : anatomy.fingers) {
    const FingerSkeleton skeleton{finger.joints, anatomy.links[finger.tip_link].T_joint_link * finger.p_tip_link};
    const FingerPose pose = pose_finger(anatomy.tree, skeleton, anatomy.q_open);
    roots.push_back(pose.origin.front());
    tips.push_back(pose.tip);
  }
  return measure_palm_plane(std::move(roots), std::move(tips), anatomy.palm_normal_palm, anatomy.thumb, anatomy.middle);
}

}  // namespace uhas
