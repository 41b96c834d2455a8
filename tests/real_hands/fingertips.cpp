// Fingertips against KDL, whose tree comes from urdfdom and not from the profile.
#include <doctest/doctest.h>

#include <algorithm>
#include <kdl/treefksolverpos_recursive.hpp>
#include <random>
#include <vector>

#include "support/kdl_tree.hpp"
#include "support/real_profile.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

KDL::Vector to_kdl(Vector3d a) { return {a.x, a.y, a.z}; }

JointValues random_values(const urdf::ModelInterface& urdf, std::mt19937_64& random) {
  JointValues values;
  for (const auto& [name, joint] : urdf.joints_) {
    if (joint->type == urdf::Joint::FIXED || joint->mimic) continue;
    const bool unlimited = joint->type == urdf::Joint::CONTINUOUS;
    values[name] = std::uniform_real_distribution(unlimited ? -3.0 : joint->limits->lower,
                                                  unlimited ? 3.0 : joint->limits->upper)(random);
  }
  return values;
}

}  // namespace

TEST_CASE("fingertips relative to the palm are KDL's, single and in a batch, in double and float") {
  constexpr int postures = 1000;
  const HandProfile& profile = real_profile();
  const auto urdf = read_urdf(real_hand().urdf);
  const KDL::Tree tree = kdl_tree(*urdf);
  KDL::TreeFkSolverPos_recursive solver(tree);
  const auto frame = [&](const KDL::JntArray& q, const std::string& link) {
    KDL::Frame T;
    REQUIRE(solver.JntToCart(q, T, link) >= 0);
    return T;
  };

  std::mt19937_64 random(1);
  std::vector<double> q, expected;
  for (int n = 0; n < postures; ++n) {
    const JointValues values = random_values(*urdf, random);
    for (const Joint& joint : profile.tree.joints) q.push_back(value_of(*urdf, joint.name, values));
    const KDL::JntArray q_kdl = kdl_values(*urdf, tree, values);
    const KDL::Frame T_palm_root = frame(q_kdl, profile.palm_link).Inverse();
    for (const ProfileFinger& finger : profile.fingers) {
      const KDL::Vector p =
          T_palm_root * (frame(q_kdl, profile.links[finger.tip_link].name) * to_kdl(finger.p_tip_link));
      expected.insert(expected.end(), {p.x(), p.y(), p.z()});
    }
  }

  const FingertipKinematics<double> exact(profile);
  const FingertipKinematics<float> rounded(profile);
  const std::size_t joints = exact.joint_count(), numbers = 3 * exact.finger_count();
  std::vector<double> single(expected.size()), batch(expected.size());
  for (std::size_t n = 0; n < postures; ++n)
    REQUIRE(exact.fingertips(std::span(q).subspan(n * joints, joints),
                             std::span(single).subspan(n * numbers, numbers)) == Status::ok);
  REQUIRE(exact.fingertips_batch(q, batch) == Status::ok);
  std::vector<float> batch_float(expected.size());
  REQUIRE(rounded.fingertips_batch(std::vector<float>(q.begin(), q.end()), batch_float) == Status::ok);

  double worst = 0, worst_float = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    worst = std::max({worst, std::abs(single[i] - expected[i]), std::abs(batch[i] - expected[i])});
    worst_float = std::max(worst_float, std::abs(double(batch_float[i]) - expected[i]));
  }
  CHECK(worst <= 1e-9);
  CHECK(worst_float <= 1e-6);
  MESSAGE(profile.hand << ": worst " << worst << " m, in float " << worst_float << " m");
}
