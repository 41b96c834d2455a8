#include "uhas/sphere_frame/sphere_frame.hpp"

#include <cmath>
#include <numbers>

#include "uhas/anatomy/palm_plane.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/sphere_frame/slots.hpp"

namespace uhas {

SphereFrame compute_sphere_frame(const Anatomy& anatomy, const SphereFrameOptions& options) {
  const std::size_t count = anatomy.fingers.size();
  if (count < 2 || count > kSlotCount)
    throw Error(ErrorCode::invalid_hand, "", "the hand has " + std::to_string(count) + " fingers",
                "the action space has driving planes for two to five");

  // palm centre, l, and how far the finger roots are from one plane
  const PalmPlane plane = measure_palm_plane(anatomy);
  const Vector3d n = anatomy.palm_normal_palm;
  SphereFrame frame;
  frame.palm_center_palm = plane.center;
  double squares = 0;
  for (std::size_t i = 0; i < count; ++i) {
    frame.tip_distance.push_back(norm(plane.tips[i] - plane.center));
    frame.mean_tip_distance += frame.tip_distance.back() / static_cast<double>(count);
    const double height = dot(plane.roots[i] - plane.center, n);
    squares += height * height;
  }
  frame.palm_plane_rms = std::sqrt(squares / static_cast<double>(count));

  // a quarter of the sphere's circumference reaches from the palm to the mean fingertip: r = 2 l / pi
  frame.radius_scale = options.radius_scale;
  frame.radius = options.radius_scale * 2 * frame.mean_tip_distance / std::numbers::pi;
  if (!(frame.radius > 0) || !std::isfinite(frame.radius))
    throw Error(ErrorCode::invalid_hand, "", "the open fingertips all lie in the palm centre",
                "check the joint origins of the model");

  // S: z along the palm normal, the origin one radius out of the palm centre, so that the sphere touches the palm
  frame.T_palm_sphere = {Rotationd::from_columns(plane.x, plane.y, n), plane.center + frame.radius * n};

  // the slots, by where the fingers stand on a right hand
  frame.mirrored = anatomy.handedness == Handedness::left;
  const auto canonical = [&](double azimuth) { return frame.mirrored ? wrap_angle(-azimuth) : azimuth; };
  std::vector<double> place;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d middle = (plane.roots[i] + plane.tips[i]) / 2 - plane.center;
    frame.open_azimuth.push_back(canonical(plane.azimuth[i]));
    place.push_back(canonical(std::atan2(dot(middle, plane.y), dot(middle, plane.x))));
  }
  SlotAssignment assignment =
      assign_slots(frame.open_azimuth, place, plane.thumb_finger, anatomy.thumb >= 0, options.merge_pinky);
  frame.slots = std::move(assignment.slots);
  frame.own_slot = std::move(assignment.own_slot);
  frame.names = std::move(assignment.names);
  if (options.merge_pinky && count < kSlotCount)
    frame.warnings.push_back("merging the pinky's slot changes nothing on a hand of " + std::to_string(count) +
                             " fingers: only one of five has a ring finger and a pinky");
  return frame;
}

Vector3d fingertip_in_sphere(const Anatomy& anatomy, const SphereFrame& frame, int finger, std::span<const double> q) {
  const FingerAnatomy& f = anatomy.fingers[finger];
  const ProfileLink& tip_link = anatomy.links[f.tip_link];
  Vector3d p = tip_link.T_joint_link * f.p_tip_link;
  for (int i = tip_link.joint; i >= 0; i = anatomy.tree.joints[i].parent) {
    const Joint& joint = anatomy.tree.joints[i];
    p = joint.T_parent_joint * (joint_motion(joint, q[i]) * p);
  }
  const RigidTransformd& S = frame.T_palm_sphere;
  return S.rotation.transposed() * (p - S.translation);
}

}  // namespace uhas
