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
  const std::vector<Joint>& joints = profile.tree.joints;

  FingertipChain<Real> chain;
  Vector3d p = tip.T_joint_link * profile.fingers[finger].p_tip_link;
  if (tip.joint >= 0) p = axis_frame(joints[tip.joint]).transposed() * p;
  chain.p_tip = p.cast<Real>();

  double turn_of_child = 0;  // a of the joint further out
  for (int i = tip.joint; i >= 0; i = joints[i].parent) {
    const Joint& joint = joints[i];
    RigidTransformd T = joint.T_parent_joint;
    T.rotation = T.rotation * axis_frame(joint);
    if (joint.parent >= 0) T = RigidTransformd{axis_frame(joints[joint.parent]).transposed(), {}} * T;
    const TurnTiltTurn turns(T.rotation);

    const bool follows = joint.mimic_master >= 0;
    const double turn = turns.second + turn_of_child;
    ChainJoint<Real> placed;
    placed.source = follows ? joint.mimic_master : i;
    placed.prismatic = joint.kind == JointKind::prismatic;
    placed.ratio = static_cast<Real>(follows ? joint.mimic_multiplier : 1.0);
    const double offset = follows ? joint.mimic_offset : 0.0;
    placed.offset = static_cast<Real>(placed.prismatic ? offset : std::remainder(offset + turn, 2 * std::numbers::pi));
    placed.turn_cosine = static_cast<Real>(std::cos(turn));
    placed.turn_sine = static_cast<Real>(std::sin(turn));
    placed.tilt_cosine = static_cast<Real>(std::cos(turns.tilt));
    placed.tilt_sine = static_cast<Real>(std::sin(turns.tilt));
    placed.origin = turned_about_z(T.translation, -turns.first).cast<Real>();
    chain.joints.push_back(placed);
    turn_of_child = turns.first;
  }
  chain.base_cosine = static_cast<Real>(std::cos(turn_of_child));
  chain.base_sine = static_cast<Real>(std::sin(turn_of_child));
  return chain;
}

template FingertipChain<float> compile_chain(const HandProfile&, int);
template FingertipChain<double> compile_chain(const HandProfile&, int);

}  // namespace uhas
