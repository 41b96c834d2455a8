// Hands built joint by joint in the frame of their sphere: P = S, the centre is the origin, the radius 1 m. The palm
// plane is z = -1.
#pragma once

#include <utility>
#include <vector>

#include "support/toy_tree.hpp"
#include "uhas/classification/joint_classes.hpp"

namespace uhas::test {

struct SphereHand {
  Anatomy anatomy;
  SphereFrame frame;

  SphereHand() {
    anatomy.hand = "sphere hand";
    frame.radius = 1;
  }

  KinematicTree& tree() { return anatomy.tree; }

  /// A finger of these joints, its tip at `p_tip` (in S, at q = 0), open at zero; returns its index.
  int add_finger(const std::vector<int>& joints, Vector3d p_tip) {
    const int carrier = joints.back();
    FingerAnatomy finger;
    finger.joints = joints;
    finger.tip_link = static_cast<int>(anatomy.links.size());
    finger.p_tip_link = p_tip - origin_at_zero(anatomy.tree, carrier);
    anatomy.links.push_back({"tip" + std::to_string(finger.tip_link), carrier, {}});
    anatomy.fingers.push_back(finger);
    anatomy.q_open.resize(anatomy.tree.joints.size());
    frame.names.push_back("finger" + std::to_string(anatomy.fingers.size()));
    frame.own_slot.push_back(static_cast<int>(frame.own_slot.size()));
    return static_cast<int>(anatomy.fingers.size()) - 1;
  }

  Vector3d tip(int finger, const std::vector<double>& q) const {
    return fingertip_in_sphere(anatomy, frame, finger, q);
  }
};

/// A finger in the plane y = 0, straight along +x at q = 0.
struct PlanarFinger {
  Vector3d root{0.3, 0, -1};
  std::vector<double> lengths{0.5, 0.4, 0.3};  ///< of its phalanges
  double back = 0.5, closing = 1.8;            ///< how far each joint turns away from and toward the sphere (rad)
  double sign = 1;                             ///< of the joint values that close it
};

/// Adds the joints of a planar finger after those of `inner`, and the finger; returns its index.
inline int add_planar_finger(SphereHand& hand, const PlanarFinger& finger, std::vector<int> inner = {}) {
  Vector3d at = finger.root;
  for (double length : finger.lengths) {
    const double ends[2] = {-finger.sign * finger.back, finger.sign * finger.closing};
    inner.push_back(add_hinge(hand.tree(), inner.empty() ? -1 : inner.back(), at, {0, -finger.sign, 0},
                              std::min(ends[0], ends[1]), std::max(ends[0], ends[1])));
    at.x += length;
  }
  return hand.add_finger(inner, at);
}

/// Every length of the hand times `factor`.
inline SphereHand scaled(SphereHand hand, double factor) {
  for (Joint& joint : hand.anatomy.tree.joints) {
    joint.T_parent_joint.translation = factor * joint.T_parent_joint.translation;
    if (joint.kind == JointKind::prismatic) joint.lower *= factor, joint.upper *= factor;
  }
  for (FingerAnatomy& finger : hand.anatomy.fingers) finger.p_tip_link = factor * finger.p_tip_link;
  hand.frame.radius *= factor;
  return hand;
}

/// The hand's image in the plane y = 0; it moves as its original's image does for the same joint values.
inline SphereHand mirrored(SphereHand hand) {
  const auto flip = [](Vector3d p) { return Vector3d{p.x, -p.y, p.z}; };
  for (Joint& joint : hand.anatomy.tree.joints) {
    joint.T_parent_joint.translation = flip(joint.T_parent_joint.translation);
    joint.axis = joint.kind == JointKind::prismatic ? flip(joint.axis) : -flip(joint.axis);
  }
  for (FingerAnatomy& finger : hand.anatomy.fingers) finger.p_tip_link = flip(finger.p_tip_link);
  hand.frame.mirrored = !hand.frame.mirrored;
  return hand;
}

/// Classes by hand: the joints named are lateral, all others encompassing.
inline std::vector<JointClassification> classes_with(const SphereHand& hand, const std::vector<int>& lateral) {
  std::vector<JointClassification> classes(hand.anatomy.tree.joints.size());
  for (int joint : lateral) classes[joint].joint_class = JointClass::lateral;
  return classes;
}

}  // namespace uhas::test
