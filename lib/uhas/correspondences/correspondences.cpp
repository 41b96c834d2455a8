#include "uhas/correspondences/correspondences.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "uhas/base/errors.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/correspondences/point_weights.hpp"
#include "uhas/correspondences/rays/ray_caster.hpp"
#include "uhas/correspondences/rays/triangle.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

void check(const CorrespondenceOptions& options) {
  if (options.samples < 1) throw Error(ErrorCode::invalid_config, "", "samples must be at least 1", "");
  if (options.points_per_link < 1) throw Error(ErrorCode::invalid_config, "", "points per link must be at least 1", "");
  if (!(options.max_radius_deviation > 0) || !std::isfinite(options.max_radius_deviation))
    throw Error(ErrorCode::invalid_config, "", "the bound on the radius deviation must be positive and finite", "");
}

/// The meshes of all links in S (m), the hand standing at `q`.
std::vector<PosedMesh> pose_meshes(const HandModel& model, const Anatomy& anatomy, const SphereFrame& frame,
                                   std::span<const double> q) {
  const std::vector<RigidTransformd> T_palm_link = link_poses(anatomy.tree, anatomy.links, q);
  const RigidTransformd T_sphere_palm = frame.T_palm_sphere.inverse();

  std::vector<PosedMesh> posed;
  for (std::size_t i = 0; i < anatomy.links.size(); ++i)
    posed.push_back({&model.links[anatomy.model_links[i]].mesh, T_sphere_palm * T_palm_link[i]});
  return posed;
}

/// Direction `i` of `count` that cover the unit sphere evenly, from the palm pole to the far one: equal steps along the
/// axis, the golden section of a turn between neighbours.
Vector3d fibonacci_direction(int i, int count) {
  const double z = (2.0 * i + 1) / count - 1;
  const double turns = i * (std::numbers::phi - 1);
  const double azimuth = 2 * std::numbers::pi * (turns - std::floor(turns));
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

/// Between canonical and physical coordinates of S on a mirrored hand (docs/conventions.md#left-hands);
/// its own inverse.
Vector3d mirror(Vector3d p) { return {p.x, -p.y, p.z}; }

/// Sample `i` of `count` in S. A left hand gets the mirror image of a right hand's; a hand that is neither gets every
/// direction with its mirror image, for its mirror image is such a hand too.
Vector3d sample_direction(int i, int count, Handedness handedness) {
  if (handedness == Handedness::none) {
    const Vector3d direction = fibonacci_direction(i / 2, (count + 1) / 2);
    return i % 2 == 0 ? direction : mirror(direction);
  }
  const Vector3d direction = fibonacci_direction(i, count);
  return handedness == Handedness::left ? mirror(direction) : direction;
}

std::vector<std::string> missing_links(const HandModel& model, const Anatomy& anatomy, std::span<const LinkHits> hits) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < anatomy.links.size(); ++i) {
    const ProfileLink& link = anatomy.links[i];
    const bool has_mesh = !model.links[anatomy.model_links[i]].mesh.triangles.empty();
    if (link.joint < 0 || !has_mesh || hits[i].kept > 0) continue;
    const bool unseen = hits[i].too_far == 0 && hits[i].facing_away == 0;
    warnings.push_back("link '" + link.name + "' has no surface point: " +
                       (unseen ? std::string("other links hide it from the sphere's centre")
                               : std::to_string(hits[i].too_far) +
                                     " rays from the sphere's centre met it too far from the sphere, " +
                                     std::to_string(hits[i].facing_away) + " from behind"));
  }
  return warnings;
}

}  // namespace

Correspondences project_sphere_samples(const HandModel& model, const Anatomy& anatomy, const SphereFrame& frame,
                                       std::span<const double> q_sphere, const CorrespondenceOptions& options) {
  check(options);

  // the hand posed in S, ready to be hit
  const std::vector<PosedMesh> posed = pose_meshes(model, anatomy, frame, q_sphere);
  if (std::ranges::all_of(posed, [](const PosedMesh& link) { return link.mesh->triangles.empty(); }))
    throw Error(ErrorCode::invalid_hand, "", "no link of the hand has a mesh",
                "add <visual> or <collision> geometry to its links");
  const RayCaster caster(posed);
  std::vector<double> outward;  // one a link: +1, or -1 when the triangles of its mesh show their back to the outside
  for (const PosedMesh& link : posed) outward.push_back(is_inside_out(*link.mesh) ? -1 : 1);

  // one ray for each sample
  Correspondences result;
  result.hits.resize(anatomy.links.size());
  for (int sample = 0; sample < options.samples; ++sample) {
    const Vector3d direction = sample_direction(sample, options.samples, anatomy.handedness);
    const std::optional<TriangleHit> hit = caster.first_hit({}, direction);
    if (!hit) continue;

    // the triangle that the ray caster named, in its link's frame and in S
    LinkHits& hits = result.hits[hit->mesh];
    const RigidTransformd& T_sphere_link = posed[hit->mesh].T_world_mesh;
    const Triangle t_link = mesh_triangle(*posed[hit->mesh].mesh, hit->triangle);
    const Triangle t_sphere{T_sphere_link * t_link[0], T_sphere_link * t_link[1], T_sphere_link * t_link[2]};

    // a triangle seen from behind is no surface of the hand: the ray entered an open mesh
    const RayMeeting meeting = meet_from_origin(t_sphere, direction);
    if (!(outward[hit->mesh] * meeting.facing < 0)) {
      ++hits.facing_away;
      continue;
    }

    // a point far from the sphere stands for no part of it
    const Vector3d p_sphere = point_at(t_sphere, meeting.barycentric);
    const Spherical<double> s = to_spherical(frame.mirrored ? mirror(p_sphere) : p_sphere);
    const double rho = s.radius / frame.radius;
    if (!(std::abs(rho - 1) <= options.max_radius_deviation)) {
      ++hits.too_far;
      continue;
    }

    // what stays: the place on the link, and the coordinates on the sphere
    ++hits.kept;
    Correspondence point;
    point.link = static_cast<int>(hit->mesh);
    point.p_link = point_at(t_link, meeting.barycentric);
    point.normal_link = normalized(outward[hit->mesh] * area_normal(t_link));
    point.theta = wrap_angle(s.azimuth);
    point.phi = s.polar;
    point.rho = rho;
    result.points.push_back(point);
  }

  std::ranges::stable_sort(result.points, {}, &Correspondence::link);
  assign_point_weights(result.points, anatomy.links, options.points_per_link);
  result.warnings = missing_links(model, anatomy, result.hits);
  return result;
}

}  // namespace uhas
