#include "kdl_peer.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/kdl_tree.hpp"

namespace uhas::benchmark {
namespace {

constexpr double kTolerance = 1e-4;   // m, as for the peer of our own
constexpr int kMostIterations = 500;  // KDL's own default

}  // namespace

KdlPeer::KdlPeer(const HandCase& hand) {
  const auto urdf = test::read_urdf(hand.urdf);
  const KDL::Tree tree = test::kdl_tree(*urdf);
  Eigen::Matrix<double, 6, 1> position_only;
  position_only << 1, 1, 1, 0, 0, 0;

  fingers_.reserve(hand.fingers());  // the solvers refer to their chain, which must not move
  for (const ProfileFinger& finger : hand.profile.fingers) {
    Finger& made = fingers_.emplace_back();
    const std::string& tip_link = hand.profile.links[finger.tip_link].name;
    if (!tree.getChain(hand.profile.palm_link, tip_link, made.chain))
      throw std::runtime_error("no chain to " + tip_link);
    const Vector3d p = finger.p_tip_link;
    if (norm(p) > 0)
      made.chain.addSegment(
          KDL::Segment("fingertip", KDL::Joint(KDL::Joint::None), KDL::Frame(KDL::Vector(p.x, p.y, p.z))));
    for (const KDL::Segment& segment : made.chain.segments) {
      if (segment.getJoint().getType() == KDL::Joint::None) continue;
      const auto& joints = hand.profile.tree.joints;
      made.joints.push_back(
          int(std::ranges::find(joints, segment.getJoint().getName(), &Joint::name) - joints.begin()));
    }
    made.q_in.resize(unsigned(made.joints.size()));
    made.q_out.resize(unsigned(made.joints.size()));
    made.forward = std::make_unique<KDL::ChainFkSolverPos_recursive>(made.chain);
    made.inverse = std::make_unique<KDL::ChainIkSolverPos_LMA>(made.chain, position_only, kTolerance, kMostIterations);
  }
}

void KdlPeer::fingertips(std::span<const double> q, std::span<double> fingertips) {
  double* out = fingertips.data();
  KDL::Frame T;
  for (Finger& finger : fingers_) {
    for (std::size_t i = 0; i < finger.joints.size(); ++i) finger.q_in(unsigned(i)) = q[finger.joints[i]];
    finger.forward->JntToCart(finger.q_in, T);
    for (int axis = 0; axis < 3; ++axis) *out++ = T.p[axis];
  }
}

void KdlPeer::reach(std::span<const double> targets, std::span<double> q) {
  const double* target = targets.data();
  for (Finger& finger : fingers_) {
    for (std::size_t i = 0; i < finger.joints.size(); ++i) finger.q_in(unsigned(i)) = q[finger.joints[i]];
    const KDL::Frame T(KDL::Vector(target[0], target[1], target[2]));
    finger.inverse->CartToJnt(finger.q_in, T, finger.q_out);
    for (std::size_t i = 0; i < finger.joints.size(); ++i) q[finger.joints[i]] = finger.q_out(unsigned(i));
    target += 3;
  }
}

}  // namespace uhas::benchmark
