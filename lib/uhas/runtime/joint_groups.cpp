#include "uhas/runtime/joint_groups.hpp"

namespace uhas {
namespace {

std::vector<int> joints_of_class(const HandProfile& profile, JointClass wanted) {
  std::vector<int> joints;
  for (int i = 0; i < static_cast<int>(profile.joint_traits.size()); ++i)
    if (profile.joint_traits[i].joint_class == wanted) joints.push_back(i);
  return joints;
}

}  // namespace

std::vector<int> lateral_joints(const HandProfile& profile) { return joints_of_class(profile, JointClass::lateral); }

std::vector<int> encompassing_joints(const HandProfile& profile) {
  return joints_of_class(profile, JointClass::encompassing);
}

std::vector<double> reference_posture(const HandProfile& profile) {
  std::vector<double> q;
  for (const JointTraits& traits : profile.joint_traits) q.push_back(traits.q_sphere);
  return q;
}

}  // namespace uhas
