// A posed hand on its sphere as a binary glTF file, which any 3D viewer opens.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "uhas/geometry/hand_geometry.hpp"

namespace uhas {

/// A GLB file (glTF 2.0, metres). The root node, named after the hand, turns S so that viewers show the palm from the
/// front, fingers up. Its children: a node a link with geometry, named after it; `sphere`, the undeformed sphere,
/// translucent; `sphere_axes`, x red, y green and z blue, 1.25 radii long; `correspondences`, a point each. Sphere and
/// points have the colours of their (theta, phi).
/// @param q  one value a joint of the profile (rad or m), taken as it is
std::vector<std::byte> hand_glb(const HandProfile& profile, const HandGeometry& geometry, std::span<const double> q);

}  // namespace uhas
