#include "uhas/geometry/hand_geometry.hpp"

#include <algorithm>

#include "uhas/base/errors.hpp"

namespace uhas {

std::size_t triangle_count(const HandGeometry& geometry) {
  std::size_t count = 0;
  for (const TriangleMesh& mesh : geometry.links) count += mesh.triangles.size();
  return count;
}

HandGeometry hand_geometry(const HandProfile& profile, const HandModel& model, const std::string& file) {
  HandGeometry geometry;
  for (const ProfileLink& link : profile.links) {
    const auto found = std::ranges::find(model.links, link.name, &ModelLink::name);
    if (found == model.links.end())
      throw Error(ErrorCode::invalid_model, file, "has no link " + link.name + ", which the hand profile has",
                  "name the model that the profile was built from");
    geometry.links.push_back(found->mesh);
  }
  return geometry;
}

}  // namespace uhas
