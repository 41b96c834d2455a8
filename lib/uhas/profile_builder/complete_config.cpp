#include "uhas/profile_builder/complete_config.hpp"

namespace uhas {
namespace {

/// The last joint of a finger, which no other finger has; "" for none.
std::string finger_name(const Anatomy& anatomy, int finger) {
  return finger < 0 ? "" : anatomy.tree.joints[anatomy.fingers[finger].joints.back()].name;
}

}  // namespace

HandConfig complete_config(const BuildStages& stages, const BuildSettings& settings) {
  const Anatomy& anatomy = stages.anatomy;
  const std::vector<Joint>& joints = anatomy.tree.joints;
  HandConfig config;
  config.palm_link = anatomy.palm_link;
  config.palm_normal_in_root = anatomy.palm_normal_root;
  for (const FingerAnatomy& finger : anatomy.fingers) {
    std::vector<std::string>& chain = config.fingers.emplace_back();
    for (const int joint : finger.joints) chain.push_back(joints[joint].name);
    config.fingertips.push_back({anatomy.links[finger.tip_link].name, finger.p_tip_link, finger.pad_normal_link});
  }
  config.thumb = finger_name(anatomy, anatomy.thumb);
  config.middle_finger = finger_name(anatomy, anatomy.middle);
  config.handedness = anatomy.handedness;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].mimic_master >= 0) continue;
    config.q_open[joints[i].name] = anatomy.q_open[i];
    config.q_closed[joints[i].name] = stages.q_closed[i];
  }
  config.joint_limits = settings.config.joint_limits;
  return config;
}

}  // namespace uhas
