// A small hand profile, made by hand: a left hand with two fingers, five joints (one mimics another, one slides), one
// lateral table, and twelve correspondences whose sphere coordinates follow from their points.
#pragma once

#include <string>

#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

inline Joint small_joint(std::string name, int parent, Vector3d axis, RigidTransformd T_parent_joint, double lower,
                         double upper) {
  Joint joint;
  joint.name = std::move(name);
  joint.parent = parent;
  joint.axis = axis;
  joint.T_parent_joint = T_parent_joint;
  joint.lower = lower;
  joint.upper = upper;
  joint.velocity_limit = 3;
  return joint;
}

inline double small_table_theta(double q) { return 0.2 - 1.1 * q - 0.05 * q * q * q; }

inline LateralTable small_lateral_table() {
  LateralTable table;
  table.joint = 0;
  table.neutral = 0.1;
  table.theta_initial = small_table_theta(0.1);
  for (int i = 0; i < 5; ++i) {
    table.q.push_back(-0.4 + 0.2 * i);
    table.theta.push_back(small_table_theta(table.q.back()));
  }
  table.q.back() = 0.4;
  table.delta_theta_lower = table.theta.back() - table.theta_initial;
  table.delta_theta_upper = table.theta.front() - table.theta_initial;
  table.inverse_q = {0.4, 0.3, 0.2, 0.1, -0.1, -0.25, -0.4};
  return table;
}

/// Sphere coordinates of every correspondence at q_sphere.
inline void place_on_sphere(HandProfile& profile) {
  std::vector<double> q;
  for (const JointTraits& traits : profile.joint_traits) q.push_back(traits.q_sphere);
  std::vector<RigidTransformd> T_palm_joint(q.size());
  forward_kinematics(profile.tree, q, T_palm_joint);
  const RigidTransformd T_sphere_palm = profile.T_palm_sphere.inverse();
  for (Correspondence& point : profile.correspondences) {
    const ProfileLink& link = profile.links[point.link];
    const RigidTransformd T_palm_link =
        link.joint < 0 ? link.T_joint_link : T_palm_joint[link.joint] * link.T_joint_link;
    const Spherical<double> s = to_spherical(T_sphere_palm * (T_palm_link * point.p_link));
    point.theta = profile.mirrored ? wrap_angle(-s.azimuth) : s.azimuth;
    point.phi = s.polar;
    point.rho = s.radius / profile.radius;
  }
}

inline HandProfile small_profile() {
  HandProfile p;
  p.hand = "small hand";
  p.handedness = Handedness::left;
  p.mirrored = true;
  p.palm_link = "palm";
  p.root_link = "base";
  p.T_root_palm = {Rotationd::about({0, 0, 1}, 0.3), {0, 0, 0.1}};
  p.T_palm_sphere = {Rotationd::about(normalized(Vector3d{1, 2, -1}), 0.2), {0.03, 0.002, 0.05}};
  p.radius = 0.08;
  p.mean_tip_distance = 0.125;
  p.palm_center_palm = {0.02, 0, 0};
  p.palm_plane_rms = 0.001;

  p.tree.joints = {
      small_joint("index_side", -1, {0, 0, 1}, {{}, {0.05, 0.01, 0}}, -0.5, 0.5),
      small_joint("index_base", 0, {0, 1, 0}, {Rotationd::about({1, 0, 0}, 0.1), {0.02, 0, 0}}, -0.2, 1.6),
      small_joint("index_tip", 1, {0, 1, 0}, {{}, {0.045, 0, 0.002}}, 0, 1.5),
      small_joint("thumb_base", -1, normalized(Vector3d{1, 1, 0.5}),
                  {Rotationd::about({0, 0, 1}, -1.2), {0, 0.03, 0.01}}, -1, 1),
      small_joint("thumb_slide", 3, {1, 0, 0}, {Rotationd::about({0, 1, 0}, 0.4), {0.04, 0, 0}}, 0, 0.02),
  };
  p.tree.joints[2].mimic_master = 1;
  p.tree.joints[2].mimic_multiplier = 0.8;
  p.tree.joints[2].mimic_offset = 0.05;
  p.tree.joints[3].kind = JointKind::continuous;
  p.tree.joints[4].kind = JointKind::prismatic;

  p.joint_traits.resize(5);
  p.joint_traits[0].joint_class = JointClass::lateral;
  const double poses[5][3] = {{0, 0.1, 0}, {0, 0.7, 1.6}, {0.05, 0.61, 1.33}, {0.1, 0.4, 1}, {0, 0.01, 0.02}};
  for (std::size_t i = 0; i < 5; ++i) {
    JointTraits& traits = p.joint_traits[i];
    traits.lateral_motion = 0.01 * static_cast<double>(i);
    traits.encompassing_motion = 0.03;
    traits.margin = 0.5;
    traits.flexed_probe = i == 0;
    traits.q_open = poses[i][0];
    traits.q_sphere = poses[i][1];
    traits.q_closed = poses[i][2];
  }
  p.other_joints = {"wrist", "Zeigefinger-Stütze"};

  p.links = {{"palm", -1, {}},   {"index_1", 0, {Rotationd::about({0, 1, 0}, 0.2), {0.001, 0, 0}}},
             {"index_2", 1, {}}, {"index_3", 2, {{}, {0, 0, -0.001}}},
             {"thumb_1", 3, {}}, {"thumb_2", 4, {Rotationd::about({1, 0, 0}, 1.0), {0.01, 0, 0}}}};
  p.fingers.resize(2);
  p.fingers[0] = {.name = "index",
                  .slots = {true, true, true, true, false},
                  .joints = {0, 1, 2},
                  .tip_link = 3,
                  .p_tip_link = {0.03, 0, 0},
                  .pad_normal_link = {0, 0, -1},
                  .tip_distance = 0.14,
                  .theta_initial = small_table_theta(0.1),
                  .tip_phi = 1.5,
                  .lateral_table = 0};
  p.fingers[1] = {.name = "thumb",
                  .slots = {false, false, false, false, true},
                  .joints = {3, 4},
                  .tip_link = 5,
                  .p_tip_link = {0.025, 0, 0},
                  .pad_normal_link = {0, 1, 0},
                  .tip_distance = 0.11,
                  .theta_initial = -2,
                  .tip_phi = 1.4,
                  .lateral_table = -1};
  p.lateral_tables = {small_lateral_table()};

  for (int i = 0; i < 12; ++i) {
    Correspondence point;
    point.link = i / 2;
    point.p_link = {0.01 + 0.012 * (i % 2), 0.002 * i - 0.01, 0.006};
    point.normal_link = normalized(Vector3d{0.1, 0.05 * i, 1});
    point.weight = point.link == 0 ? 0 : 0.5 + 0.1 * (i % 3);
    p.correspondences.push_back(point);
  }
  place_on_sphere(p);

  p.findings = {{"palm_link", "palm", "the only link with two fingers", 0.9},
                {"thumb", "thumb", "it opposes the index", 0.7}};
  p.warnings = {"the hand is small"};
  p.settings_json = R"({"samples":12})";
  p.sources = {{"small_hand.urdf", std::string(64, 'a')}, {"package://small/palm.stl", std::string(64, '0')}};
  return p;
}

}  // namespace uhas::test
