#include "json/profile_summary_json.hpp"

#include <algorithm>

#include "json/stage_json.hpp"
#include "text/words.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas::tools {
namespace {

/// {joint name: value} of one pose.
Json pose_json(const HandProfile& profile, double JointTraits::*pose) {
  Json values = Json::object();
  for (std::size_t i = 0; i < profile.tree.joints.size(); ++i)
    values[profile.tree.joints[i].name] = profile.joint_traits[i].*pose;
  return values;
}

Json joint_json(const HandProfile& profile, int index) {
  const Joint& joint = profile.tree.joints[index];
  return {{"name", joint.name},
          {"class", to_word(profile.joint_traits[index].joint_class)},
          {"lower", joint.lower},
          {"upper", joint.upper},
          {"mimic", mimic_json(profile.tree, index)}};
}

Json finger_json(const HandProfile& profile, const ProfileFinger& finger,
                 std::span<const RigidTransformd> T_palm_joint) {
  const ProfileLink& tip = profile.links[finger.tip_link];
  const RigidTransformd T_palm_link = (tip.joint < 0 ? RigidTransformd{} : T_palm_joint[tip.joint]) * tip.T_joint_link;

  Json joints = Json::array();
  for (const int joint : finger.joints) joints.push_back(joint_json(profile, joint));

  Json lateral_joint = nullptr;
  Json delta_theta_range = {0.0, 0.0};
  if (finger.lateral_table >= 0) {
    const LateralTable& table = profile.lateral_tables[finger.lateral_table];
    lateral_joint = profile.tree.joints[table.joint].name;
    delta_theta_range = {table.delta_theta_lower, table.delta_theta_upper};
  }
  return {{"name", finger.name},
          {"slots", slot_numbers(finger.slots)},
          {"tip_link", tip.name},
          {"tip_in_root_at_open", to_json(profile.T_root_palm * (T_palm_link * finger.p_tip_link))},
          {"joints", joints},
          {"lateral_joint", lateral_joint},
          {"theta_initial", finger.theta_initial},
          {"delta_theta_range", delta_theta_range},
          {"tip_phi", finger.tip_phi},
          {"correspondences", points_of_finger(profile, finger)}};
}

}  // namespace

int points_of_finger(const HandProfile& profile, const ProfileFinger& finger) {
  return static_cast<int>(std::ranges::count_if(profile.correspondences, [&](const Correspondence& point) {
    return std::ranges::find(finger.joints, profile.links[point.link].joint) != finger.joints.end();
  }));
}

Json profile_summary_json(const HandProfile& profile) {
  const std::size_t joint_count = profile.tree.joints.size();
  std::vector<double> q_open(joint_count);
  Json joint_names = Json::array();
  for (std::size_t i = 0; i < joint_count; ++i) {
    q_open[i] = profile.joint_traits[i].q_open;
    joint_names.push_back(profile.tree.joints[i].name);
  }
  std::vector<RigidTransformd> T_palm_joint(joint_count);
  forward_kinematics(profile.tree, q_open, T_palm_joint);
  const RigidTransformd T_root_sphere = profile.T_root_palm * profile.T_palm_sphere;

  Json confidence = Json::object();
  for (const HandFinding& finding : profile.findings) confidence[finding.item] = finding.confidence;
  Json fingers = Json::array();
  for (const ProfileFinger& finger : profile.fingers) fingers.push_back(finger_json(profile, finger, T_palm_joint));

  Json document = new_document("uhas-profile-summary");
  document["hand"] = profile.hand;
  document["handedness"] = to_word(profile.handedness);
  document["mirrored"] = profile.mirrored;
  document["palm_link"] = profile.palm_link;
  document["confidence"] = confidence;
  document["palm_normal_in_root"] = to_json(T_root_sphere.rotation.column(2));
  document["sphere"] = {{"radius", profile.radius},
                        {"center_in_root", to_json(T_root_sphere.translation)},
                        {"rotation_in_root", to_json(T_root_sphere.rotation)}};
  document["joint_names"] = joint_names;
  document["q_open"] = pose_json(profile, &JointTraits::q_open);
  document["q_sphere"] = pose_json(profile, &JointTraits::q_sphere);
  document["q_closed"] = pose_json(profile, &JointTraits::q_closed);
  document["other_joints"] = profile.other_joints;
  document["fingers"] = fingers;
  document["warnings"] = profile.warnings;
  return document;
}

}  // namespace uhas::tools
