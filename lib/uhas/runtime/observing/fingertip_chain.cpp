#include "uhas/runtime/observing/fingertip_chain.hpp"

#include <cmath>
#include <numbers>

#include "uhas/kinematics/axis_frame.hpp"

namespace uhas {
namespace {

Vector3d turned_about_z(Vector3d p, double angle) { return Rotationd::about({0, 0, 1}, angle) * p; }

/// R = Rz(first) Rx(tilt) Rz(second). Where tilt is near zero only first + second is well defined; `second` is made to
/// fit whatever `first` became.
struct TurnTiltTurn {
  double first, tilt, second;

  explicit TurnTiltTurn(const Rotationd& R) {
    const Vector3d z = R.column(2);  // (sin first sin tilt, -cos first sin tilt, cos tilt)
    const double sine = std::hypot(z.x, z.y);
    first = sine > 0 ? std::atan2(z.x, -z.y) : 0.0;
    tilt = std::atan2(sine, z.z);
    const Rotationd rest = Rotationd::about({1, 0, 0}, -tilt) * Rotationd::about({0, 0, 1}, -first) * R;
    second = std::atan2(rest.m[3], rest.m[0]);
  }
};

}  // namespace

template <class Real>
FingertipChain<Real> compile_chain(const HandProfile& profile, int finger) {
  const ProfileLink& tip = profile.links[profile.fingers[finger].tip_link];
  FingertipChain<Real> chain;

  // the fingertip in its joint's frame, whose z is the axis
  Vector3d p = tip.T_joint_link * profile.fingers[finger].p_tip_link;
  if (tip.joint >= 0) p = axis_frame(profile.tree.joints[tip.joint]).transposed() * p;
  chain.p_tip = p.cast<Real>();

  // inward: R = Rz(first) Rx(tilt) Rz(second) of each joint, of which the parent takes `first`
  double turn_of_child = 0;
  for (int i = tip.joint; i >= 0; i = profile.tree.joints[i].parent) {
    const CompiledJoint<double> joint = compile_joint(profile.tree, i, RigidTransformd{}, LengthUnits{});
    const RigidTransformd& T = joint.T_parent_joint;
    const TurnTiltTurn turns(T.rotation);
    const double turn = turns.second + turn_of_child;
    turn_of_child = turns.first;

    ChainJoint<Real> placed{joint.JointMotion::template cast<Real>()};
    if (!joint.prismatic) placed.offset = static_cast<Real>(std::remainder(joint.offset + turn, 2 * std::numbers::pi));
    placed.turn_cosine = static_cast<Real>(std::cos(turn));
    placed.turn_sine = static_cast<Real>(std::sin(turn));
    placed.tilt_cosine = static_cast<Real>(std::cos(turns.tilt));
    placed.tilt_sine = static_cast<Real>(std::sin(turns.tilt));
    placed.origin = turned_about_z(T.translation, -turns.first).cast<Real>();
    chain.joints.push_back(placed);
  }
  chain.base_cosine = static_cast<Real>(std::cos(turn_of_child));
  chain.base_sine = static_cast<Real>(std::sin(turn_of_child));
  return chain;
}

template FingertipChain<float> compile_chain(const HandProfile&, int);
template FingertipChain<double> compile_chain(const HandProfile&, int);

}  // namespace uhas
