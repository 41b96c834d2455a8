// Hands of boxes on slides, whose distances are known by construction: every joint slides along x from the palm, by
// default half a metre either way, and its link's frame is at x = q.
#pragma once

#include <string>

#include "uhas/geometry/hand_geometry.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

/// A closed box, triangles outward.
inline TriangleMesh make_box(Vector3d center, Vector3d size) {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.vertices.push_back(
        center + Vector3d{(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y, (i & 4 ? 0.5 : -0.5) * size.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Both meshes as one.
inline TriangleMesh merged(TriangleMesh a, const TriangleMesh& b) {
  const auto base = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  return a;
}

/// The same surface seen from the other side.
inline TriangleMesh turned_inside_out(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

struct SlidingBoxes {
  HandProfile profile;
  HandGeometry geometry;

  /// A link that slides on joint `parent`, -1 = the palm; returns its joint. `q_rest`: its value in the three poses
  /// of the profile.
  int add(const TriangleMesh& mesh, double q_rest, int parent = -1, double lower = -0.5, double upper = 0.5) {
    Joint joint;
    joint.name = "slide_" + std::to_string(profile.tree.joints.size());
    joint.kind = JointKind::prismatic;
    joint.parent = parent;
    joint.axis = {1, 0, 0};
    joint.lower = lower;
    joint.upper = upper;
    profile.tree.joints.push_back(joint);
    JointTraits traits;
    traits.q_open = traits.q_sphere = traits.q_closed = q_rest;
    profile.joint_traits.push_back(traits);
    add_link(mesh, static_cast<int>(profile.tree.joints.size()) - 1);
    return static_cast<int>(profile.tree.joints.size()) - 1;
  }

  /// A link fixed to `joint`, -1 = the palm.
  void add_link(const TriangleMesh& mesh, int joint) {
    profile.links.push_back({"link_" + std::to_string(profile.links.size()), joint, {}});
    geometry.links.push_back(mesh);
  }
};

}  // namespace uhas::test
