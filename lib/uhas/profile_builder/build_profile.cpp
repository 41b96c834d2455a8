#include "uhas/profile_builder/build_profile.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "uhas/base/errors.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/classification/closed_pose_finding.hpp"
#include "uhas/profile_builder/build_stages.hpp"
#include "uhas/profile_builder/settings_json.hpp"

namespace uhas {
namespace {

std::vector<JointTraits> joint_traits(const BuildStages& stages) {
  std::vector<JointTraits> traits(stages.anatomy.tree.joints.size());
  for (std::size_t i = 0; i < traits.size(); ++i) {
    const JointClassification& found = stages.joint_classes[i];
    traits[i] = {found.joint_class,  found.lateral_motion,     found.encompassing_motion,         found.margin,
                 found.flexed_probe, stages.anatomy.q_open[i], stages.lateral_tables.q_sphere[i], stages.q_closed[i]};
  }
  return traits;
}

ProfileFinger profile_finger(const BuildStages& stages, int index) {
  const FingerAnatomy& anatomy = stages.anatomy.fingers[index];
  const SphereFrame& frame = stages.sphere_frame;

  ProfileFinger finger;
  finger.name = frame.names[index];
  finger.slots = frame.slots[index];
  finger.joints = anatomy.joints;
  finger.tip_link = anatomy.tip_link;
  finger.p_tip_link = anatomy.p_tip_link;
  finger.pad_normal_link = anatomy.pad_normal_link;
  finger.tip_distance = frame.tip_distance[index];
  finger.lateral_table = stages.lateral_tables.table_of_finger[index];

  // the driving plane stands where the fingertip is on the wrapped hand; a table knows its azimuth unwrapped
  const Spherical<double> tip =
      to_spherical(fingertip_in_sphere(stages.anatomy, frame, index, stages.lateral_tables.q_sphere));
  finger.tip_phi = tip.polar;
  finger.theta_initial = finger.lateral_table >= 0 ? stages.lateral_tables.tables[finger.lateral_table].theta_initial
                                                   : wrap_angle(frame.mirrored ? -tip.azimuth : tip.azimuth);
  return finger;
}

}  // namespace

BuildStages run_stages(const std::string& urdf_path, const BuildSettings& settings, BuildStage last,
                       const BuildListener& listener) {
  if (listener) listener("reading the URDF and its meshes");
  HandModel model = load_hand_model(urdf_path, settings.load);
  try {
    return run_stages(std::move(model), settings, last, listener);
  } catch (const Error& error) {  // the stages know no file; what is wrong with the hand is wrong with this one
    if (error.code() != ErrorCode::invalid_hand) throw;
    throw Error(error.code(), urdf_path, error.what(), "");
  }
}

BuildStages run_stages(HandModel model, const BuildSettings& settings, BuildStage last, const BuildListener& listener) {
  BuildStages stages;
  stages.model = std::move(model);
  const auto begin = [&](BuildStage stage, const char* name) {
    if (stage > last) return false;
    if (listener) listener(name);
    return true;
  };

  if (!begin(BuildStage::anatomy, "finding palm and fingers")) return stages;
  stages.anatomy = infer_anatomy(stages.model, settings.config);

  if (!begin(BuildStage::sphere_frame, "placing the sphere")) return stages;
  stages.sphere_frame = compute_sphere_frame(stages.anatomy, settings.sphere_frame);

  if (!begin(BuildStage::classification, "classifying joints")) return stages;
  stages.q_closed = find_closed_pose(stages.anatomy, stages.sphere_frame, settings.config);
  stages.joint_classes = classify_joints(stages.anatomy, stages.sphere_frame, stages.q_closed);
  stages.closed_pose =
      explain_closed_pose(stages.anatomy, stages.sphere_frame, stages.joint_classes, stages.q_closed, settings.config);

  if (!begin(BuildStage::lateral_tables, "wrapping the hand and sweeping lateral joints")) return stages;
  stages.lateral_tables = build_lateral_tables(stages.anatomy, stages.sphere_frame, stages.joint_classes,
                                               stages.q_closed, settings.lateral_tables);

  if (!begin(BuildStage::correspondences, "casting rays on the hand's surface")) return stages;
  stages.correspondences = project_sphere_samples(stages.model, stages.anatomy, stages.sphere_frame,
                                                  stages.lateral_tables.q_sphere, settings.correspondences);
  return stages;
}

std::vector<std::string> stage_warnings(const BuildStages& stages) {
  const std::string doubtful = doubt(stages.closed_pose);
  const std::vector<std::string> closed_pose_warnings(doubtful.empty() ? 0 : 1, doubtful);
  std::vector<std::string> all;
  for (const auto* warnings :
       {&stages.model.warnings, &stages.anatomy.warnings, &stages.sphere_frame.warnings, &closed_pose_warnings,
        &stages.lateral_tables.warnings, &stages.correspondences.warnings})
    all.insert(all.end(), warnings->begin(), warnings->end());
  return all;
}

std::vector<HandFinding> stage_findings(const BuildStages& stages) {
  std::vector<HandFinding> findings = stages.anatomy.findings;
  findings.push_back(stages.closed_pose);
  return findings;
}

std::vector<int> fingers_by_slot(const SphereFrame& frame) {
  // of fingers that share a slot, the finger that stands in the lower one goes first
  const auto first_slot = [&](int finger) {
    return std::pair(std::ranges::find(frame.slots[finger], true) - frame.slots[finger].begin(),
                     frame.own_slot[finger]);
  };
  std::vector<int> order(frame.slots.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, first_slot);
  return order;
}

HandProfile make_profile(const BuildStages& stages, const BuildSettings& settings) {
  const Anatomy& anatomy = stages.anatomy;
  const SphereFrame& frame = stages.sphere_frame;

  HandProfile profile;
  profile.hand = anatomy.hand;
  profile.handedness = anatomy.handedness;
  profile.mirrored = frame.mirrored;
  profile.palm_link = anatomy.palm_link;
  profile.root_link = anatomy.root_link;
  profile.T_root_palm = anatomy.T_root_palm;
  profile.T_palm_sphere = frame.T_palm_sphere;
  profile.radius = frame.radius;
  profile.radius_scale = frame.radius_scale;
  profile.mean_tip_distance = frame.mean_tip_distance;
  profile.palm_center_palm = frame.palm_center_palm;
  profile.palm_plane_rms = frame.palm_plane_rms;

  profile.tree = anatomy.tree;
  profile.joint_traits = joint_traits(stages);
  profile.other_joints = anatomy.other_joints;
  profile.links = anatomy.links;
  for (const int finger : fingers_by_slot(frame)) profile.fingers.push_back(profile_finger(stages, finger));
  profile.lateral_tables = stages.lateral_tables.tables;
  profile.correspondences = stages.correspondences.points;

  profile.findings = stage_findings(stages);
  profile.warnings = stage_warnings(stages);
  profile.settings_json = to_canonical_json(settings);
  profile.sources = stages.model.sources;

  validate_profile(profile, profile.hand);
  return profile;
}

HandProfile build_profile(const std::string& urdf_path, const BuildSettings& settings, const BuildListener& listener) {
  return make_profile(run_stages(urdf_path, settings, BuildStage::correspondences, listener), settings);
}

}  // namespace uhas
