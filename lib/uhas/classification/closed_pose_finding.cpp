#include "uhas/classification/closed_pose_finding.hpp"

#include <algorithm>

#include "uhas/classification/finger_sweep.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// Outward pad normal of each finger in the open pose, in S.
std::vector<Vector3d> pad_normals(const Anatomy& anatomy, const SphereFrame& frame) {
  std::vector<RigidTransformd> T_palm_joint(anatomy.tree.joints.size());
  forward_kinematics(anatomy.tree, anatomy.q_open, T_palm_joint);
  std::vector<Vector3d> normals;
  for (const FingerAnatomy& finger : anatomy.fingers) {
    const ProfileLink& tip = anatomy.links[finger.tip_link];
    const Vector3d normal_palm =
        T_palm_joint[tip.joint].rotation * (tip.T_joint_link.rotation * finger.pad_normal_link);
    normals.push_back(frame.T_palm_sphere.rotation.transposed() * normal_palm);
  }
  return normals;
}

}  // namespace

HandFinding explain_closed_pose(const Anatomy& anatomy, const SphereFrame& frame,
                                std::span<const JointClassification> classes, std::span<const double> q_closed,
                                const HandConfig& config) {
  constexpr double first_step = 0.05;  // of the way from open to closed
  const std::vector<Vector3d> pad_normal = pad_normals(anatomy, frame);
  std::size_t independent = 0;
  int watched = 0, toward_pad = 0;
  for (int joint = 0; joint < static_cast<int>(anatomy.tree.joints.size()); ++joint) {
    if (anatomy.tree.joints[joint].mimic_master >= 0) continue;
    ++independent;
    if (classes[joint].joint_class != JointClass::encompassing) continue;
    std::vector<double> q = anatomy.q_open;
    set_with_followers(anatomy.tree, joint, q[joint] + first_step * (q_closed[joint] - q[joint]), q);
    for (const int finger : fingers_moved(anatomy, joint)) {
      const Vector3d way =
          fingertip_in_sphere(anatomy, frame, finger, q) - fingertip_in_sphere(anatomy, frame, finger, anatomy.q_open);
      ++watched;
      if (dot(way, pad_normal[finger]) > 0) ++toward_pad;
    }
  }
  if (config.q_closed.size() == independent) return {"q_closed", "fingers closed", kStatedInConfig, 1};
  return {"q_closed", "fingers closed", "the end on whose side the fingertip comes nearest to the sphere's centre",
          watched > 0 ? static_cast<double>(toward_pad) / watched : 1};
}

}  // namespace uhas
