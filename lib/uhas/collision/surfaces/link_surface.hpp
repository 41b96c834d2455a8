// The surface of one link, in FCL's hierarchy of bounding volumes.
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>

#include <vector>

#include "uhas/base/rigid_transform.hpp"
#include "uhas/collision/surfaces/pieces.hpp"

namespace uhas {

/// `T` below: the frame of the other link in the frame of this one.
class LinkSurface {
 public:
  /// `mesh`: in the link's frame (m), with at least one triangle.
  explicit LinkSurface(TriangleMesh mesh);

  /// Whether the surfaces meet, or one encloses a whole piece of the other.
  bool in_contact(const LinkSurface& other, const RigidTransformd& T) const;

  /// At most the distance of the surfaces (m): that of their outermost bounding volumes.
  double least_possible_distance(const LinkSurface& other, const RigidTransformd& T) const;

  /// The distance of the surfaces (m), or `limit` when it is not less. 0 where triangles meet.
  double distance(const LinkSurface& other, const RigidTransformd& T, double limit) const;

 private:
  bool encloses_piece_of(const LinkSurface& other, const RigidTransformd& T) const;

  TriangleMesh mesh_;
  std::vector<PieceExtremes> pieces_;
  Vector3d lower_, upper_;                 // bounding box
  Vector3d center_;                        // of the box and of a sphere about the mesh
  double radius_ = 0;                      // of that sphere
  fcl::BVHModel<fcl::OBBRSSd> triangles_;  // in millimetres
};

}  // namespace uhas
