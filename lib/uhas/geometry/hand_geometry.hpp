// The surface of a hand as its profile divides it: one mesh a link. A profile holds no meshes; they come
// from its model.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas {

struct HandGeometry {
  std::vector<TriangleMesh> links;  ///< one a link of the profile, in its frame (m); empty for a link without geometry
};

/// Triangles over all links.
std::size_t triangle_count(const HandGeometry& geometry);

/// The meshes of `model` for the links of `profile`, which was built from it.
/// Throws Error(invalid_model), naming `file`, when the model lacks a link of the profile.
HandGeometry hand_geometry(const HandProfile& profile, const HandModel& model, const std::string& file);

}  // namespace uhas
