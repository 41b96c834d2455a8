#include "uhas/anatomy/opening/posture.hpp"

namespace uhas {

FingerPosture measure_posture(const KinematicTree& tree, const FingerSkeleton& finger, const Flexion& flexion,
                              std::span<const double> q) {
  const FingerPose pose = pose_finger(tree, finger, q);
  FingerPosture posture;
  posture.root = pose.origin.front();
  posture.tip = pose.tip;
  posture.knuckle = pose.origin[flexion.positions.front()];
  const Vector3d along = posture.tip - posture.knuckle;
  const Vector3d axis = flexion.closing.sign * pose.axis[flexion.positions.back()];
  posture.direction = normalized(orthogonal_part(along, axis));
  if (flexion.sliding) {  // its axis is the way that it closes
    posture.closing = axis;
    posture.axis = cross(posture.direction, posture.closing);
  } else {
    posture.axis = axis;
    posture.closing = cross(posture.axis, posture.direction);
  }
  return posture;
}

std::vector<FingerPosture> measure_postures(const HandSkeleton& hand, std::span<const Flexion> flexions,
                                            std::span<const double> q) {
  std::vector<FingerPosture> postures;
  for (std::size_t i = 0; i < flexions.size(); ++i)
    postures.push_back(measure_posture(hand.tree, hand.fingers[i], flexions[i], q));
  return postures;
}

}  // namespace uhas
