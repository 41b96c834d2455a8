#include "uhas/report/correspondences_ply.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "uhas/report/posed_hand.hpp"
#include "uhas/report/sphere_colour.hpp"
#include "uhas/runtime/joint_groups.hpp"

namespace uhas {
namespace {

/// Names come from strangers' files; a line break in one would end the comment.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

}  // namespace

std::string correspondences_ply(const HandProfile& profile) {
  std::string text = "ply\nformat ascii 1.0\ncomment correspondences of " + one_line(profile.hand) +
                     ", in the sphere frame at q_sphere\ncomment metres and radians; rho in sphere radii\n";
  for (std::size_t i = 0; i < profile.links.size(); ++i)
    text += "comment link " + std::to_string(i) + " " + one_line(profile.links[i].name) + "\n";
  text += "element vertex " + std::to_string(profile.correspondences.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text += std::string("property float ") + name + "\n";
  for (const char* name : {"red", "green", "blue"}) text += std::string("property uchar ") + name + "\n";
  for (const char* name : {"theta", "phi", "rho", "weight"}) text += std::string("property float ") + name + "\n";
  text += "property int link\nend_header\n";

  const std::vector<RigidTransformd> T_sphere_link = link_poses_in_sphere(profile, reference_posture(profile));
  for (const Correspondence& c : profile.correspondences) {
    const Vector3d p = T_sphere_link[c.link] * c.p_link, n = T_sphere_link[c.link].rotation * c.normal_link;
    const auto colour = sphere_colour_bytes(c.theta, c.phi);
    std::array<char, 320> line{};
    std::snprintf(line.data(), line.size(), "%.7g %.7g %.7g %.5g %.5g %.5g %d %d %d %.7g %.7g %.7g %.7g %d\n", p.x, p.y,
                  p.z, n.x, n.y, n.z, colour[0], colour[1], colour[2], c.theta, c.phi, c.rho, c.weight, c.link);
    text += line.data();
  }
  return text;
}

}  // namespace uhas
