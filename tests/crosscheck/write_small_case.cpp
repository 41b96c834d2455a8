// Writes the small profile and, in the form of a solution file, numbers that the second reader must arrive at: forward
// kinematics of every link, and residuals known in closed form.
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "support/small_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using nlohmann::json;

namespace {

json to_json(const RigidTransformd& T) {
  const auto& R = T.rotation.m;
  const Vector3d& p = T.translation;
  return {{R[0], R[1], R[2], p.x}, {R[3], R[4], R[5], p.y}, {R[6], R[7], R[8], p.z}, {0, 0, 0, 1}};
}

json link_poses(const HandProfile& profile, std::span<const double> q) {
  std::vector<RigidTransformd> T_palm_joint(q.size());
  forward_kinematics(profile.tree, q, T_palm_joint);
  json poses;
  for (const ProfileLink& link : profile.links)
    poses[link.name] = to_json(link.joint < 0 ? link.T_joint_link : T_palm_joint[link.joint] * link.T_joint_link);
  return poses;
}

/// One displacement for all driving vectors of a finger.
struct Deformation {
  double delta_theta = 0, delta_r = 0;
};

/// Residual of q_sphere, where every point is at its rest coordinates: a point of radius rho and a target of
/// radius t at the same polar angle, turned by delta theta, are sqrt((rho - t)^2 + 4 rho t sin^2(phi) sin^2(delta
/// theta / 2)) apart.
double residual_at_q_sphere(const HandProfile& profile, Deformation index, Deformation thumb) {
  constexpr double phi_1 = std::numbers::pi / 3;
  double error_sum = 0, weight_sum = 0;
  for (const Correspondence& point : profile.correspondences) {
    if (profile.links[point.link].joint < 0) continue;
    const Deformation& finger = profile.links[point.link].joint < 3 ? index : thumb;
    const double t = std::max(point.rho + finger.delta_r * std::min(point.phi / phi_1, 1.0), 0.0);
    const double half_chord = std::sin(point.phi) * std::sin(finger.delta_theta / 2);
    const double u = std::clamp((1 + finger.delta_r) / 0.5, 0.0, 1.0);
    const double weight = point.weight * u * u * (3 - 2 * u);
    error_sum += weight * ((point.rho - t) * (point.rho - t) + 4 * point.rho * t * half_chord * half_chord);
    weight_sum += weight;
  }
  return weight_sum > 0 ? std::sqrt(error_sum / weight_sum) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_small_case FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  const HandProfile profile = test::small_profile();
  write_profile(profile, folder + "/profile.h5");

  std::vector<double> q_sphere;
  for (const JointTraits& traits : profile.joint_traits) q_sphere.push_back(traits.q_sphere);
  json joint_names, solutions = json::array(), actions = json::array();
  for (const Joint& joint : profile.tree.joints) joint_names.push_back(joint.name);

  // the index owns slots 0 to 3, whose inputs are averaged after clamping; the thumb has no lateral table
  const auto add_case = [&](const json& action, Deformation index, Deformation thumb) {
    const double residual = residual_at_q_sphere(profile, index, thumb);
    actions.push_back(action);
    solutions.push_back({{"q", q_sphere}, {"residual_rms", std::isfinite(residual) ? json(residual) : json()}});
  };
  const double lower = profile.lateral_tables[0].delta_theta_lower, upper = profile.lateral_tables[0].delta_theta_upper;
  add_case(std::vector<double>(15, 0.0), {}, {});
  add_case({0.1, 0.1, 0.1, 0.1, 0, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, -0.3, -0.3}, {0.1, 0.2}, {0, -0.3});
  add_case({0.2, 0, 0, 0, 0.4, 0.4, 0.4, 0.2, 0.2, 0, 0, -0.2, -0.2, -0.7, -0.7}, {0.05, 0.1}, {0, -0.7});
  add_case({9, 9, -9, 0, 0, 5, 5, 0, 0, 0, 0, 0, 0, -0.8, -0.8}, {(2 * upper + lower) / 4, 0.5}, {0, -0.8});
  add_case({{"lateral", {0, 0, 0, 0, 0}}, {"radial", std::vector<std::vector<double>>(5, {-0.6, -0.6})}}, {0, -0.6},
           {0, -0.6});
  add_case({{"lateral", {0, 0, 0, 0, 0}}, {"radial", std::vector<std::vector<double>>(5, {-2, -2})}}, {0, -2}, {0, -2});

  std::mt19937 random(7);
  json poses = json::array();
  for (int i = 0; i < 20; ++i) {
    std::vector<double> q;
    for (const Joint& joint : profile.tree.joints)
      q.push_back(std::uniform_real_distribution(joint.lower, joint.upper)(random));
    apply_mimics(profile.tree, q);
    poses.push_back({{"q", q}, {"T_palm_link", link_poses(profile, q)}});
  }

  std::ofstream(folder + "/actions.json") << json{{"format", "uhas-actions"}, {"version", 1}, {"actions", actions}};
  std::ofstream(folder + "/solution.json") << json{{"format", "uhas-solution"},
                                                   {"version", 1},
                                                   {"joint_names", joint_names},
                                                   {"solutions", solutions},
                                                   {"poses", poses}};
}
