#include "uhas/anatomy/fingers/finger_names.hpp"

#include <algorithm>

#include "uhas/anatomy/config_names.hpp"

namespace uhas {

std::string describe_finger(const HandSkeleton& hand, int finger) {
  if (finger < 0) return "none";
  const std::vector<int>& joints = hand.fingers[finger].joints;
  return hand.tree.joints[joints.front()].name + " .. " + hand.tree.joints[joints.back()].name;
}

int find_named_finger(const HandSkeleton& hand, const std::string& joint_name, const HandConfig& config,
                      const std::string& key) {
  if (joint_name.empty()) return -1;
  const int joint = find_joint(hand.tree, joint_name, config, key, "no finger has a joint");
  int found = -1;
  for (int i = 0; i < hand.finger_count(); ++i) {
    if (std::ranges::find(hand.fingers[i].joints, joint) == hand.fingers[i].joints.end()) continue;
    if (found >= 0)
      refuse_config(config, key, "several fingers have the joint \"" + joint_name + "\"", "name a joint further out");
    found = i;
  }
  if (found < 0)
    refuse_config(config, key, "\"" + joint_name + "\" only drives joints of fingers", "name a joint of a finger");
  return found;
}

}  // namespace uhas
