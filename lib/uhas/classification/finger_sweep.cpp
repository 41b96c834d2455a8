#include "uhas/classification/finger_sweep.hpp"

#include <algorithm>

#include "uhas/kinematics/mimics.hpp"

namespace uhas {

std::vector<int> fingers_moved(const Anatomy& anatomy, int joint) {
  std::vector<int> fingers;
  for (int f = 0; f < static_cast<int>(anatomy.fingers.size()); ++f) {
    const std::vector<int>& joints = anatomy.fingers[f].joints;
    if (std::any_of(joints.begin(), joints.end(), [&](int j) { return turns_with(anatomy.tree, j, joint); }))
      fingers.push_back(f);
  }
  return fingers;
}

std::vector<int> joints_further_out(const Anatomy& anatomy, int finger, int joint) {
  std::vector<int> further;
  bool beyond = false;
  for (int j : anatomy.fingers[finger].joints) {
    const bool own = turns_with(anatomy.tree, j, joint);
    if (beyond && !own) further.push_back(j);
    beyond = beyond || own;
  }
  return further;
}

}  // namespace uhas
