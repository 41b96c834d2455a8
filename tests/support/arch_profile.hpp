// A right hand of two fingers on one palm-arch joint: some of the arch's points stand nearer to one finger in azimuth,
// some to the other.
#pragma once

#include "support/small_profile.hpp"

namespace uhas::test {

inline HandProfile arch_profile() {
  HandProfile p;
  p.hand = "arch hand";
  p.palm_link = "palm";
  p.root_link = "palm";
  p.T_palm_sphere = {Rotationd::about({0, 0, 1}, 0.1), {0.01, 0, 0.1}};
  p.radius = 0.08;
  p.mean_tip_distance = 0.125;

  const Vector3d flexion{0, -1, 0};
  p.tree.joints = {
      small_joint("arch", -1, flexion, {{}, {0.02, 0, 0.02}}, -0.3, 0.6),
      small_joint("pinky_base", 0, flexion, {{}, {0.04, 0.03, 0}}, -0.2, 1.6),
      small_joint("index_base", 0, flexion, {{}, {0.045, -0.03, 0}}, -0.2, 1.6),
  };
  p.joint_traits.resize(3);
  const double poses[3][3] = {{0, 0.2, 0.6}, {0, 0.7, 1.6}, {0.05, 0.6, 1.6}};
  for (std::size_t i = 0; i < 3; ++i) {
    p.joint_traits[i].q_open = poses[i][0];
    p.joint_traits[i].q_sphere = poses[i][1];
    p.joint_traits[i].q_closed = poses[i][2];
  }

  p.links = {{"metacarpals", 0, {}}, {"pinky_1", 1, {}}, {"index_1", 2, {}}};
  p.fingers.resize(2);
  p.fingers[0] = {.name = "pinky",
                  .slots = {true, true, false, false, false},
                  .joints = {0, 1},
                  .tip_link = 1,
                  .p_tip_link = {0.05, 0, 0},
                  .pad_normal_link = {0, 0, 1},
                  .tip_distance = 0.125,
                  .theta_initial = 0.4};
  p.fingers[1] = {.name = "index",
                  .slots = {false, false, true, true, true},
                  .joints = {0, 2},
                  .tip_link = 2,
                  .p_tip_link = {0.05, 0, 0},
                  .pad_normal_link = {0, 0, 1},
                  .tip_distance = 0.125,
                  .theta_initial = -0.5};

  for (int i = 0; i < 18; ++i) {
    Correspondence point;
    point.link = i / 6;
    point.p_link = {0.01 + 0.012 * (i % 3), point.link == 0 ? (i < 3 ? 0.02 : -0.02) : 0.002 * (i % 6), 0.006};
    point.normal_link = {0, 0, 1};
    point.weight = 0.5 + 0.1 * (i % 4);
    p.correspondences.push_back(point);
  }
  place_on_sphere(p);
  return p;
}

}  // namespace uhas::test
