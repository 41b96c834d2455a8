// Fingertips with their derivatives, for the peers that iterate: the cheapest forward kinematics there is in the
// project, so that no peer is slow for the sake of its kinematics.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "uhas/runtime/observing/fingertip_chain.hpp"

namespace uhas::benchmark {

inline constexpr int kMostUnknowns = 8;  ///< independent joints of one finger

/// A finger as the peers see it: its chain, and its independent joints as unknowns.
struct PeerFinger {
  FingertipChain<double> chain;
  std::vector<int> unknowns;          ///< profile's index of each
  std::vector<int> unknown_of_joint;  ///< [joint of the chain, fingertip to palm] index into `unknowns`
  std::vector<double> lower, upper;   ///< [unknown] limits

  PeerFinger(const HandProfile& profile, int finger);
};

using Jacobian = std::array<Vector3d, kMostUnknowns>;  ///< [unknown] m/rad, m/m

/// The fingertip (m, palm frame) and its derivatives by the finger's unknowns.
/// @param q  called as q(unknown): its value
template <class ValueOf>
Vector3d fingertip_with_jacobian(const PeerFinger& finger, ValueOf q, Jacobian& jacobian) {
  struct Axis {
    Vector3d origin, direction;
  };
  std::array<Axis, 2 * kMostUnknowns> axes;
  const auto& joints = finger.chain.joints;

  Vector3d x{finger.chain.base_cosine, finger.chain.base_sine, 0}, y{-x.y, x.x, 0}, z{0, 0, 1}, at{};
  for (std::size_t i = joints.size(); i-- > 0;) {
    const ChainJoint<double>& joint = joints[i];
    at += joint.origin.x * x + joint.origin.y * y + joint.origin.z * z;
    const Vector3d tilted = joint.tilt_cosine * y + joint.tilt_sine * z;
    z = joint.tilt_cosine * z - joint.tilt_sine * y;
    axes[i] = {at, z};
    const double motion = joint.ratio * q(finger.unknown_of_joint[i]) + joint.offset;
    double cosine = joint.turn_cosine, sine = joint.turn_sine;
    if (joint.prismatic)
      at += motion * z;
    else
      cosine = std::cos(motion), sine = std::sin(motion);
    const Vector3d turned = cosine * x + sine * tilted;
    y = cosine * tilted - sine * x;
    x = turned;
  }
  const Vector3d tip = at + finger.chain.p_tip.x * x + finger.chain.p_tip.y * y + finger.chain.p_tip.z * z;

  for (std::size_t u = 0; u < finger.unknowns.size(); ++u) jacobian[u] = {};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Vector3d moved = joints[i].prismatic ? axes[i].direction : cross(axes[i].direction, tip - axes[i].origin);
    jacobian[finger.unknown_of_joint[i]] += joints[i].ratio * moved;
  }
  return tip;
}

}  // namespace uhas::benchmark
