#include "uhas/anatomy/fingers/hand_skeleton.hpp"

#include "uhas/base/errors.hpp"

namespace uhas {

double finger_length(const KinematicTree& tree, const FingerSkeleton& finger) {
  double length = norm(finger.p_tip_joint);
  for (std::size_t i = 1; i < finger.joints.size(); ++i)
    length += norm(tree.joints[finger.joints[i]].T_parent_joint.translation);
  return length;
}

double mean_finger_length(const HandSkeleton& hand) {
  double mean = 0;
  for (const FingerSkeleton& finger : hand.fingers) mean += finger_length(hand.tree, finger) / hand.finger_count();
  return mean;
}

HandSkeleton make_hand_skeleton(const PalmTree& palm, std::span<const Fingertip> tips) {
  HandSkeleton hand{palm.tree, {}};
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const FingerSkeleton finger{palm.chains[i], palm.links[tips[i].link].T_joint_link * tips[i].p_link};
    if (!(finger_length(hand.tree, finger) > 0))
      throw Error(ErrorCode::invalid_hand, "",
                  "the finger of joint '" + hand.tree.joints[finger.joints.back()].name +
                      "' has no length: its tip lies on its joints",
                  "give its last link geometry, or name the joints of each finger by \"fingers\" in a hand config");
    hand.fingers.push_back(finger);
  }
  return hand;
}

}  // namespace uhas
