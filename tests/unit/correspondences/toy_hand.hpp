// A hand small enough to know every point of it: a palm and one finger link that turns about the sphere's axis.
#pragma once

#include "uhas/correspondences/correspondences.hpp"

namespace uhas::test {

struct ToyHand {
  HandModel model;
  Anatomy anatomy;
  SphereFrame frame;
  std::vector<double> q;
};

/// A rectangle in the plane x = `x`, its front toward -x.
inline TriangleMesh plate(double x, double half_y, double half_z) {
  return {{{x, -half_y, -half_z}, {x, half_y, -half_z}, {x, half_y, half_z}, {x, -half_y, half_z}},
          {{0, 2, 1}, {0, 3, 2}}};
}

/// The box [-a.x, a.x] x ..., moved by `center`, its faces toward the outside.
inline TriangleMesh box(Vector3d a, Vector3d center) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(center + Vector3d{i & 1 ? a.x : -a.x, i & 2 ? a.y : -a.y, i & 4 ? a.z : -a.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// The same surface with its back to the outside.
inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// Sphere: radius 0.1, centre 0.1 above the palm's origin. The joint turns about the sphere's axis, its origin is the
/// centre; the finger link's origin lies on the sphere's equator at azimuth q = 0.3.
inline ToyHand toy_hand(TriangleMesh palm, TriangleMesh finger) {
  const RigidTransformd T_palm_sphere{{}, {0, 0, 0.1}};
  const RigidTransformd T_joint_link{{}, {0.1, 0, 0}};
  const RigidTransformd at_origin;
  ToyHand hand;
  hand.model.links = {{"palm", -1, -1, at_origin, std::move(palm)}, {"finger", 0, 0, T_joint_link, std::move(finger)}};
  Joint joint;
  joint.name = "knuckle";
  joint.T_parent_joint = T_palm_sphere;
  hand.model.tree.joints = {joint};

  hand.anatomy.hand = "toy";
  hand.anatomy.handedness = Handedness::right;
  hand.anatomy.tree = hand.model.tree;
  hand.anatomy.links = {{"palm", -1, at_origin}, {"finger", 0, T_joint_link}};
  hand.anatomy.model_links = {0, 1};
  hand.frame.T_palm_sphere = T_palm_sphere;
  hand.frame.radius = 0.1;
  hand.q = {0.3};
  return hand;
}

/// The toy hand as its own image in the plane y = 0; triangles keep the order of their corners, so solids
/// turn inside out.
inline ToyHand mirrored(ToyHand hand) {
  const auto mirror = [](Vector3d p) { return Vector3d{p.x, -p.y, p.z}; };
  for (ModelLink& link : hand.model.links)
    for (Vector3d& vertex : link.mesh.vertices) vertex = mirror(vertex);
  for (double& q : hand.q) q = -q;
  hand.anatomy.handedness = Handedness::left;
  hand.frame.mirrored = true;
  return hand;
}

inline ToyHand scaled(ToyHand hand, double factor) {
  const auto scale = [factor](RigidTransformd& T) { T.translation = factor * T.translation; };
  for (ModelLink& link : hand.model.links)
    for (Vector3d& vertex : link.mesh.vertices) vertex = factor * vertex;
  for (Joint& joint : hand.anatomy.tree.joints) scale(joint.T_parent_joint);
  for (ProfileLink& link : hand.anatomy.links) scale(link.T_joint_link);
  scale(hand.frame.T_palm_sphere);
  hand.frame.radius *= factor;
  return hand;
}

inline Correspondences project(const ToyHand& hand, const CorrespondenceOptions& options = {}) {
  return project_sphere_samples(hand.model, hand.anatomy, hand.frame, hand.q, options);
}

}  // namespace uhas::test
