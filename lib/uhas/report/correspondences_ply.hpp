// The correspondences as a point cloud for any viewer of PLY files.
#pragma once

#include <string>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// An ASCII PLY file, a vertex a correspondence: position (m) and outward normal in S at q_sphere, sRGB colour
/// of (theta, phi), theta and phi (rad, canonical), rho (sphere radii), weight in the solver, link (index into
/// the file's comments).
std::string correspondences_ply(const HandProfile& profile);

}  // namespace uhas
