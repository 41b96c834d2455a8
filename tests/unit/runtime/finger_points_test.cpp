// Points along a finger that is straight in the open pose: where they stand follows by hand.
#include "uhas/runtime/finger_points.hpp"

#include <doctest/doctest.h>

#include "support/small_profile.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

using namespace uhas;

namespace {

void add_correspondence(HandProfile& profile, int link, Vector3d p_link) {
  Correspondence point;
  point.link = link;
  point.p_link = p_link;
  profile.correspondences.push_back(point);
}

/// The index finger along x of the palm: joints 0 and 1 meet in its root, joint 2 is 0.06 m further out, the tip 0.12
/// m. Its links have correspondences at 0, 0.05 and 0.1 m.
HandProfile straight_finger() {
  HandProfile profile = test::small_profile();
  std::vector<Joint>& joints = profile.tree.joints;
  joints[0].T_parent_joint = {};
  joints[1].T_parent_joint = {};
  joints[2].T_parent_joint = {{}, {0.06, 0, 0}};
  joints[2].mimic_offset = 0;
  profile.joint_traits[2].q_open = 0;
  for (int link : {1, 2, 3}) profile.links[link].T_joint_link = {};
  profile.fingers[0].p_tip_link = {0.06, 0, 0};
  std::erase_if(profile.correspondences,
                [](const Correspondence& point) { return point.link >= 1 && point.link <= 3; });
  add_correspondence(profile, 1, {0, 0, 0.01});
  add_correspondence(profile, 2, {0.05, 0, 0.01});
  add_correspondence(profile, 3, {0.04, 0, 0.01});
  return profile;
}

std::vector<int> carriers(const HandProfile& profile) {
  std::vector<int> joints;
  for (const FingerPoint& point : finger_points(profile, 0)) joints.push_back(point.joint);
  return joints;
}

}  // namespace

TEST_CASE("points stand at equal arc lengths from root to tip, joints that meet in one point add none") {
  const HandProfile profile = straight_finger();
  std::vector<RigidTransformd> T_palm_joint(5);
  forward_kinematics(profile.tree, std::vector<double>(5, 0.0), T_palm_joint);
  const auto points = finger_points(profile, 0);
  for (int k = 0; k < kFingerPoints; ++k) {
    const Vector3d p_palm = T_palm_joint[points[k].joint] * points[k].p_joint;
    CHECK(norm(p_palm - Vector3d{0.02 * k, 0, 0}) < 1e-15);
  }
}

TEST_CASE("a point goes with the nearest correspondence of its own finger") {
  HandProfile profile = straight_finger();
  CHECK(carriers(profile) == std::vector<int>{0, 0, 1, 1, 2, 2, 2});
  add_correspondence(profile, 4, profile.tree.joints[3].T_parent_joint.inverse() * Vector3d{});
  add_correspondence(profile, 0, {0.06, 0, 0});
  CHECK(carriers(profile) == std::vector<int>{0, 0, 1, 1, 2, 2, 2});
}

TEST_CASE("without correspondences a point goes with the joint that its piece of the chain begins at") {
  HandProfile profile = straight_finger();
  profile.correspondences.clear();
  CHECK(carriers(profile) == std::vector<int>{1, 1, 1, 2, 2, 2, 2});
}

TEST_CASE("a finger without length has all its points in one place") {
  HandProfile profile = straight_finger();
  profile.tree.joints[2].T_parent_joint = {};
  profile.fingers[0].p_tip_link = {};
  for (const FingerPoint& point : finger_points(profile, 0)) CHECK(norm(point.p_joint) == 0);
}
