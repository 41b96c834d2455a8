#include "uhas/runtime/observing/observation_model.hpp"

#include "uhas/kinematics/axis_frame.hpp"

namespace uhas {
namespace {

/// The finger each slot shows: its owner; of several owners the one that has been shown least.
std::array<int, kSlotCount> fingers_in_slots(const HandProfile& profile) {
  std::array<int, kSlotCount> fingers{};
  std::vector<int> times_shown(profile.fingers.size(), 0);
  for (int slot = 0; slot < kSlotCount; ++slot) {
    int shown = -1;
    for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f)
      if (profile.fingers[f].slots[slot] && (shown < 0 || times_shown[f] < times_shown[shown])) shown = f;
    ++times_shown[shown];
    fingers[slot] = shown;
  }
  return fingers;
}

}  // namespace

template <class Real>
ObservationModel<Real> compile_observation(const HandProfile& profile, const ObservationOptions& options) {
  ObservationModel<Real> model;
  model.mirror = profile.mirrored ? Real(-1) : Real(1);

  // joints from S outward: lengths in radii, but q as the caller has it
  const LengthUnits units{.motion = profile.radius, .q = 1};
  for (int i = 0; i < static_cast<int>(profile.tree.joints.size()); ++i)
    model.joints.push_back(
        compile_joint(profile.tree, i, profile.T_palm_sphere.inverse(), units).template cast<Real>());

  // what each slot shows of its finger, in the frame of the joint that carries it
  const auto carried = [&](int joint, Vector3d v) -> typename ObservationModel<Real>::CarriedVector {
    return {joint, (axis_frame(profile.tree.joints[joint]).transposed() * v).template cast<Real>()};
  };
  for (int f : fingers_in_slots(profile)) {
    const auto along = finger_points(profile, f);
    for (int k = 0; k < kFingerPoints; ++k)
      if (options.points[k]) model.points.push_back(carried(along[k].joint, along[k].p_joint / profile.radius));
    if (!options.pad_directions) continue;
    const ProfileFinger& finger = profile.fingers[f];
    const ProfileLink& tip = profile.links[finger.tip_link];
    model.pads.push_back(carried(tip.joint, tip.T_joint_link.rotation * finger.pad_normal_link));
  }
  model.size = static_cast<int>(kPointNumbers * model.points.size() + 3 * model.pads.size());
  return model;
}

template ObservationModel<float> compile_observation(const HandProfile&, const ObservationOptions&);
template ObservationModel<double> compile_observation(const HandProfile&, const ObservationOptions&);

}  // namespace uhas
