#include "uhas/collision/surfaces/link_pairs.hpp"

namespace uhas {

LinkAdjacency::LinkAdjacency(const HandProfile& profile, const std::vector<bool>& has_geometry) {
  const std::vector<Joint>& joints = profile.tree.joints;
  std::vector<bool> carries_geometry(joints.size());
  for (std::size_t i = 0; i < profile.links.size(); ++i) {
    joint_.push_back(profile.links[i].joint);
    if (joint_[i] >= 0 && has_geometry[i]) carries_geometry[joint_[i]] = true;
  }
  for (const Joint& joint : joints) {  // parents come first
    const int parent = joint.parent;
    before_.push_back(parent < 0 || carries_geometry[parent] ? parent : before_[parent]);
  }
}

bool LinkAdjacency::adjacent(int first, int second) const {
  const int a = joint_[first], b = joint_[second];
  return a == b || (a >= 0 && before_[a] == b) || (b >= 0 && before_[b] == a);
}

}  // namespace uhas
