#include "json/stage_json.hpp"

#include <algorithm>

#include "text/words.hpp"

namespace uhas::tools {
namespace {

Json hand_document(const std::string& format, const BuildStages& stages) {
  Json document = new_document(format);
  document["hand"] = stages.anatomy.hand;
  return document;
}

const std::string& joint_name(const BuildStages& stages, int joint) { return stages.anatomy.tree.joints[joint].name; }
const std::string& link_name(const BuildStages& stages, int link) { return stages.anatomy.links[link].name; }

}  // namespace

Json mimic_json(const KinematicTree& tree, int joint) {
  const int master = tree.joints[joint].mimic_master;
  return master < 0 ? Json(nullptr) : Json(tree.joints[master].name);
}

Json sphere_frame_json(const BuildStages& stages) {
  const Anatomy& anatomy = stages.anatomy;
  const SphereFrame& frame = stages.sphere_frame;
  const RigidTransformd T_root_sphere = anatomy.T_root_palm * frame.T_palm_sphere;

  Json fingers = Json::array();
  for (const int i : fingers_by_slot(frame)) {
    const Vector3d p_tip_sphere = fingertip_in_sphere(anatomy, frame, i, anatomy.q_open);
    fingers.push_back({{"name", frame.names[i]},
                       {"slots", slot_numbers(frame.slots[i])},
                       {"tip_link", link_name(stages, anatomy.fingers[i].tip_link)},
                       {"tip_in_root_at_open", to_json(T_root_sphere * p_tip_sphere)},
                       {"tip_distance", frame.tip_distance[i]},
                       {"open_azimuth", frame.open_azimuth[i]}});
  }

  Json document = hand_document("uhas-sphere-frame", stages);
  document["handedness"] = to_word(anatomy.handedness);
  document["mirrored"] = frame.mirrored;
  document["palm_link"] = anatomy.palm_link;
  document["palm_normal_in_root"] = to_json(T_root_sphere.rotation.column(2));
  document["palm_center_in_root"] = to_json(anatomy.T_root_palm * frame.palm_center_palm);
  document["palm_plane_rms"] = frame.palm_plane_rms;
  document["sphere"] = {{"radius", frame.radius},
                        {"center_in_root", to_json(T_root_sphere.translation)},
                        {"rotation_in_root", to_json(T_root_sphere.rotation)}};
  document["radius_scale"] = frame.radius_scale;
  document["mean_tip_distance"] = frame.mean_tip_distance;
  document["fingers"] = fingers;
  document["warnings"] = stage_warnings(stages);
  return document;
}

Json joint_classes_json(const BuildStages& stages) {
  Json fingers = Json::array();
  for (const int i : fingers_by_slot(stages.sphere_frame)) {
    Json joints = Json::array();
    for (const int joint : stages.anatomy.fingers[i].joints) {
      const JointClassification& found = stages.joint_classes[joint];
      joints.push_back({{"name", joint_name(stages, joint)},
                        {"class", to_word(found.joint_class)},
                        {"mimic", mimic_json(stages.anatomy.tree, joint)},
                        {"lateral_motion", found.lateral_motion},
                        {"encompassing_motion", found.encompassing_motion},
                        {"margin", found.margin},
                        {"flexed_probe", found.flexed_probe}});
    }
    fingers.push_back({{"name", stages.sphere_frame.names[i]},
                       {"slots", slot_numbers(stages.sphere_frame.slots[i])},
                       {"joints", joints}});
  }
  Json document = hand_document("uhas-joint-classes", stages);
  document["fingers"] = fingers;
  document["other_joints"] = stages.anatomy.other_joints;
  return document;
}

Json lateral_tables_json(const BuildStages& stages) {
  const LateralTables& lateral = stages.lateral_tables;
  Json fingers = Json::array();
  for (const int i : fingers_by_slot(stages.sphere_frame)) {
    const int table = lateral.table_of_finger[i];
    fingers.push_back(
        {{"name", stages.sphere_frame.names[i]},
         {"lateral_joint", table < 0 ? Json(nullptr) : Json(joint_name(stages, lateral.tables[table].joint))}});
  }
  Json tables = Json::array();
  for (const LateralTable& table : lateral.tables)
    tables.push_back({{"joint", joint_name(stages, table.joint)},
                      {"neutral", table.neutral},
                      {"theta_initial", table.theta_initial},
                      {"delta_theta_range", {table.delta_theta_lower, table.delta_theta_upper}},
                      {"q", table.q},
                      {"theta", table.theta},
                      {"inverse_q", table.inverse_q}});

  Json document = hand_document("uhas-lateral-tables", stages);
  document["fingers"] = fingers;
  document["tables"] = tables;
  document["warnings"] = stage_warnings(stages);
  return document;
}

Json surface_hits_json(const BuildStages& stages) {
  Json links = Json::array();
  for (std::size_t i = 0; i < stages.correspondences.hits.size(); ++i) {
    const LinkHits& hits = stages.correspondences.hits[i];
    links.push_back({{"name", stages.anatomy.links[i].name},
                     {"kept", hits.kept},
                     {"too_far", hits.too_far},
                     {"facing_away", hits.facing_away}});
  }
  Json document = hand_document("uhas-surface-hits", stages);
  document["points"] = stages.correspondences.points.size();
  document["links"] = links;
  document["warnings"] = stage_warnings(stages);
  return document;
}

Json surface_points_json(const BuildStages& stages) {
  Json points = Json::array();
  for (const Correspondence& point : stages.correspondences.points)
    points.push_back({{"link", link_name(stages, point.link)},
                      {"p_link", to_json(point.p_link)},
                      {"normal_link", to_json(point.normal_link)},
                      {"theta", point.theta},
                      {"phi", point.phi},
                      {"rho", point.rho},
                      {"weight", point.weight}});
  Json document = hand_document("uhas-surface-points", stages);
  document["points"] = points;
  return document;
}

}  // namespace uhas::tools
