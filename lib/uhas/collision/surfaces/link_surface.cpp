#include "uhas/collision/surfaces/link_surface.hpp"

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>

namespace uhas {
namespace {

// FCL 0.7 takes a triangle whose doubled area is under 3e-8 for degenerate and then finds wrong distances to its face:
// in metres that is one of a quarter of a millimetre, in millimetres none that a mesh has.
constexpr double kPerMetre = 1000;

fcl::Vector3d fcl_vector(Vector3d p) { return kPerMetre * fcl::Vector3d(p.x, p.y, p.z); }

fcl::Transform3d fcl_transform(const RigidTransformd& T) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result.linear()(row, column) = T.rotation.m[3 * row + column];
  result.translation() = fcl_vector(T.translation);
  return result;
}

bool is_within(Vector3d p, Vector3d lower, Vector3d upper) {
  return p.x >= lower.x && p.y >= lower.y && p.z >= lower.z && p.x <= upper.x && p.y <= upper.y && p.z <= upper.z;
}

}  // namespace

LinkSurface::LinkSurface(TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      pieces_(find_pieces(mesh_)),
      lower_(mesh_.vertices.front()),
      upper_(mesh_.vertices.front()) {
  std::vector<fcl::Vector3d> vertices;
  for (const Vector3d& p : mesh_.vertices) {
    vertices.push_back(fcl_vector(p));
    lower_ = {std::min(lower_.x, p.x), std::min(lower_.y, p.y), std::min(lower_.z, p.z)};
    upper_ = {std::max(upper_.x, p.x), std::max(upper_.y, p.y), std::max(upper_.z, p.z)};
  }
  center_ = 0.5 * (lower_ + upper_);
  for (const Vector3d& p : mesh_.vertices) radius_ = std::max(radius_, norm(p - center_));

  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh_.triangles) triangles.emplace_back(a, b, c);
  triangles_.beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  triangles_.addSubModel(vertices, triangles);
  triangles_.endModel();
}

bool LinkSurface::in_contact(const LinkSurface& other, const RigidTransformd& T) const {
  if (norm(T * other.center_ - center_) > radius_ + other.radius_) return false;
  fcl::CollisionResultd result;
  fcl::collide(&triangles_, fcl::Transform3d::Identity(), &other.triangles_, fcl_transform(T), fcl::CollisionRequestd(),
               result);
  return result.isCollision() || encloses_piece_of(other, T) || other.encloses_piece_of(*this, T.inverse());
}

bool LinkSurface::encloses_piece_of(const LinkSurface& other, const RigidTransformd& T) const {
  const auto is_within_box = [&](Vector3d corner) { return is_within(T * corner, lower_, upper_); };
  return std::ranges::any_of(other.pieces_, [&](const PieceExtremes& piece) {
    // no triangles meet: where one corner is, the whole piece is
    return std::ranges::all_of(piece, is_within_box) && std::abs(winding_number(mesh_, T * piece.front())) > 0.5;
  });
}

double LinkSurface::least_possible_distance(const LinkSurface& other, const RigidTransformd& T) const {
  const fcl::Transform3d X = fcl_transform(T);
  return fcl::distance(X.linear(), X.translation(), triangles_.getBV(0).bv, other.triangles_.getBV(0).bv) / kPerMetre;
}

double LinkSurface::distance(const LinkSurface& other, const RigidTransformd& T, double limit) const {
  fcl::DistanceResultd result(kPerMetre * limit);
  fcl::distance(&triangles_, fcl::Transform3d::Identity(), &other.triangles_, fcl_transform(T), fcl::DistanceRequestd(),
                result);
  return std::min(limit, result.min_distance / kPerMetre);
}

}  // namespace uhas
