// A hand whose scores are known by hand: two fingers on opposite sides of a sphere of radius 1 m, each a slide along
// the radius at polar angle 90 degrees. The joint values of a solve are the mean displacement of the finger's two
// driving vectors, within limits.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "support/small_profile.hpp"

namespace uhas::test {

/// Polar angles of a finger's points, all in its plane, of equal weight, `rho` from the centre at rest.
inline HandProfile slider_profile(const std::vector<double>& angles = {std::numbers::pi / 2}, double rho = 1) {
  HandProfile p;
  p.hand = "sliders";
  p.handedness = Handedness::none;
  p.palm_link = p.root_link = "palm";
  p.radius = 1;
  p.mean_tip_distance = std::numbers::pi / 2;
  p.links = {{"palm", -1, {}}};
  p.settings_json = "{}";
  p.sources = {{"sliders.urdf", std::string(64, 'a')}};
  for (int f = 0; f < 2; ++f) {
    const std::string name = f == 0 ? "front" : "back";
    const double theta = f == 0 ? 0 : std::numbers::pi, side = f == 0 ? 1 : -1;
    Joint joint = small_joint(name, -1, {side, 0, 0}, {}, -0.5, 0.5);
    joint.kind = JointKind::prismatic;
    p.tree.joints.push_back(joint);
    JointTraits traits;
    traits.encompassing_motion = traits.margin = 1;
    traits.q_open = 0.5, traits.q_closed = -0.5;
    p.joint_traits.push_back(traits);
    p.links.push_back({name, f, {}});
    p.fingers.push_back(
        {.name = name,
         .slots = f == 0 ? std::array{true, true, true, true, false} : std::array{false, false, false, false, true},
         .joints = {f},
         .tip_link = f + 1,
         .p_tip_link = {side, 0, 0},
         .pad_normal_link = {-side, 0, 0},
         .tip_distance = std::numbers::pi / 2,
         .theta_initial = theta,
         .tip_phi = std::numbers::pi / 2,
         .lateral_table = -1});
    for (double phi : angles)
      p.correspondences.push_back({.link = f + 1,
                                   .p_link = from_spherical<double>({theta, phi, rho}),
                                   .normal_link = {-side, 0, 0},
                                   .theta = theta,
                                   .phi = phi,
                                   .rho = rho,
                                   .weight = 1});
  }
  return p;
}

/// What finger 0 or 1 is asked for by an action of 15 numbers, the mean over its slots: at 60 and at 120 degrees.
inline std::array<double, 2> asked_of(const std::vector<double>& action, int finger) {
  std::array<double, 2> sum{};
  for (int slot = finger == 0 ? 0 : 4; slot < (finger == 0 ? 4 : 5); ++slot)
    for (int j = 0; j < 2; ++j) sum[j] += action[5 + 2 * slot + j] / (finger == 0 ? 4 : 1);
  return sum;
}

}  // namespace uhas::test
