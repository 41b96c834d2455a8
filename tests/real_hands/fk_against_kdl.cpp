// Forward kinematics of every link against KDL, whose tree comes from urdfdom, not from the hand model.
#include <doctest/doctest.h>

#include <cmath>
#include <kdl/treefksolverpos_recursive.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "support/kdl_tree.hpp"
#include "support/real_hand.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/model/hand_model.hpp"

namespace {

constexpr double tolerance = 1e-9;  // m and rad

double rotation_angle(const uhas::Rotationd& a, const KDL::Rotation& b) {
  // |A - B| (Frobenius) = 2 sqrt(2) sin(angle / 2), accurate where the trace is not
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += std::pow(a.m[3 * i + j] - b(i, j), 2);
  return 2 * std::asin(std::min(1.0, std::sqrt(sum / 8)));
}

}  // namespace

TEST_CASE("the pose of every link is KDL's") {
  const auto& hand = uhas::test::real_hand();
  const auto urdf = uhas::test::read_urdf(hand.urdf);
  const KDL::Tree tree = uhas::test::kdl_tree(*urdf);
  KDL::TreeFkSolverPos_recursive solver(tree);

  uhas::ModelLoadOptions skeleton_only;
  skeleton_only.load_meshes = false;
  const uhas::HandModel model = uhas::load_hand_model(hand.urdf, skeleton_only);
  REQUIRE(model.links.size() == urdf->links_.size());
  REQUIRE(model.tree.joints.size() == tree.getNrOfJoints());

  std::mt19937_64 random(1);
  std::vector<double> q(model.tree.joints.size());
  std::vector<uhas::RigidTransformd> T_root_joint(q.size());
  double worst_position = 0, worst_rotation = 0;
  for (int pose = 0; pose < 1000; ++pose) {
    uhas::test::JointValues independent;
    for (const auto& [name, joint] : urdf->joints_) {
      if (joint->type == urdf::Joint::FIXED || joint->mimic) continue;
      const bool unlimited = joint->type == urdf::Joint::CONTINUOUS;
      const double lower = unlimited ? -std::numbers::pi : joint->limits->lower;
      const double upper = unlimited ? std::numbers::pi : joint->limits->upper;
      independent[name] = std::uniform_real_distribution(lower, upper)(random);
    }
    const KDL::JntArray q_kdl = uhas::test::kdl_values(*urdf, tree, independent);
    for (std::size_t j = 0; j < q.size(); ++j)
      q[j] = model.tree.joints[j].mimic_master < 0 ? independent.at(model.tree.joints[j].name) : 0;
    uhas::apply_mimics(model.tree, q);
    uhas::forward_kinematics(model.tree, q, T_root_joint);

    for (const uhas::ModelLink& link : model.links) {
      const uhas::RigidTransformd T_root_link =
          link.joint < 0 ? link.T_joint_link : T_root_joint[link.joint] * link.T_joint_link;
      KDL::Frame expected;
      REQUIRE(solver.JntToCart(q_kdl, expected, link.name) >= 0);
      const uhas::Vector3d p{expected.p.x(), expected.p.y(), expected.p.z()};
      const double position_error = norm(T_root_link.translation - p);
      const double rotation_error = rotation_angle(T_root_link.rotation, expected.M);
      REQUIRE_MESSAGE(position_error <= tolerance, link.name);
      REQUIRE_MESSAGE(rotation_error <= tolerance, link.name);
      worst_position = std::max(worst_position, position_error);
      worst_rotation = std::max(worst_rotation, rotation_error);
    }
  }
  MESSAGE(hand.name << ": worst position " << worst_position << " m, worst rotation " << worst_rotation << " rad");
}
