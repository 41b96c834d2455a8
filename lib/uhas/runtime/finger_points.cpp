#include "uhas/runtime/finger_points.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// A surface point of the finger in the open pose.
struct SurfacePoint {
  int joint;
  Vector3d p_palm;
};

std::vector<RigidTransformd> open_pose(const HandProfile& profile) {
  std::vector<double> q;
  for (const JointTraits& traits : profile.joint_traits) q.push_back(traits.q_open);
  std::vector<RigidTransformd> T_palm_joint(q.size());
  forward_kinematics(profile.tree, q, T_palm_joint);
  return T_palm_joint;
}

std::vector<SurfacePoint> surface_of(const HandProfile& profile, const ProfileFinger& finger,
                                     const std::vector<RigidTransformd>& T_palm_joint) {
  std::vector<SurfacePoint> surface;
  for (const Correspondence& point : profile.correspondences) {
    const ProfileLink& link = profile.links[point.link];
    if (std::ranges::find(finger.joints, link.joint) == finger.joints.end()) continue;
    surface.push_back({link.joint, T_palm_joint[link.joint] * (link.T_joint_link * point.p_link)});
  }
  return surface;
}

/// The joint of the surface point nearest to `p_palm`; `otherwise` when there is no surface.
int nearest_joint(const std::vector<SurfacePoint>& surface, Vector3d p_palm, int otherwise) {
  double least = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& point : surface) {
    const double distance = norm(point.p_palm - p_palm);
    if (distance < least) least = distance, otherwise = point.joint;
  }
  return otherwise;
}

}  // namespace

std::array<FingerPoint, kFingerPoints> finger_points(const HandProfile& profile, int finger_index) {
  const ProfileFinger& finger = profile.fingers[finger_index];
  const std::vector<RigidTransformd> T_palm_joint = open_pose(profile);
  const std::vector<SurfacePoint> surface = surface_of(profile, finger, T_palm_joint);

  // the polyline, and how far along it each of its corners lies
  std::vector<Vector3d> corners;
  for (int joint : finger.joints) corners.push_back(T_palm_joint[joint].translation);
  const ProfileLink& tip_link = profile.links[finger.tip_link];
  corners.push_back(T_palm_joint[tip_link.joint] * (tip_link.T_joint_link * finger.p_tip_link));
  std::vector<double> arc{0};
  for (std::size_t i = 1; i < corners.size(); ++i) arc.push_back(arc.back() + norm(corners[i] - corners[i - 1]));

  std::array<FingerPoint, kFingerPoints> points;
  std::size_t piece = 0;
  for (int k = 0; k < kFingerPoints; ++k) {
    const double along = arc.back() * k / (kFingerPoints - 1);
    // joints that meet in one point make pieces without length, which no point lies on
    while (piece + 2 < corners.size() && along >= arc[piece + 1]) ++piece;
    const double length = arc[piece + 1] - arc[piece];
    const double share = length > 0 ? (along - arc[piece]) / length : 1;
    const Vector3d p_palm = corners[piece] + share * (corners[piece + 1] - corners[piece]);
    points[k].joint = nearest_joint(surface, p_palm, finger.joints[piece]);
    points[k].p_joint = T_palm_joint[points[k].joint].inverse() * p_palm;
  }
  return points;
}

}  // namespace uhas
