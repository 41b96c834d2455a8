#include "uhas/anatomy/fingers/fingertip.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/nearest_name.hpp"

namespace uhas {
namespace {

/// A frame is a tip frame from this part of the group's extent along the finger on; covers and pads sit nearer the
/// joint, markers and tool frames stand off the surface.
constexpr double kNearestTipFrame = 0.6, kFarthestTipFrame = 1.25;
/// The outer part of the group whose surface is the fingertip.
constexpr double kTipCap = 0.1;

/// Calls `visit(area, centroid, corners)` with every triangle of `link`, in the frame of the joint that carries it.
template <class Visit>
void for_each_triangle(const HandModel& model, const Anatomy& anatomy, std::size_t link, Visit visit) {
  const TriangleMesh& mesh = model.links[anatomy.model_links[link]].mesh;
  const RigidTransformd& T_joint_link = anatomy.links[link].T_joint_link;
  for (const auto& triangle : mesh.triangles) {
    const std::array<Vector3d, 3> corner = {T_joint_link * mesh.vertices[triangle[0]],
                                            T_joint_link * mesh.vertices[triangle[1]],
                                            T_joint_link * mesh.vertices[triangle[2]]};
    visit(norm(cross(corner[1] - corner[0], corner[2] - corner[0])) / 2, (corner[0] + corner[1] + corner[2]) / 3.0,
          corner);
  }
}

/// The surface of one rigid group along the finger.
struct Surface {
  double area = 0;
  Vector3d direction;  ///< from the joint's origin toward the middle of the surface, unit
  double extent = 0;   ///< how far the surface reaches in that direction (m)
};

Surface measure_surface(const HandModel& model, const Anatomy& anatomy, const std::vector<std::size_t>& links) {
  Surface surface;
  Vector3d moment;
  for (std::size_t link : links) {
    for_each_triangle(model, anatomy, link, [&](double area, Vector3d centroid, const auto&) {
      surface.area += area;
      moment += area * centroid;
    });
  }
  if (!(surface.area > 0)) return surface;
  surface.direction = normalized(moment / surface.area);
  for (std::size_t link : links) {
    for_each_triangle(model, anatomy, link, [&](double, Vector3d, const auto& corners) {
      for (const Vector3d& corner : corners) surface.extent = std::max(surface.extent, dot(corner, surface.direction));
    });
  }
  return surface;
}

/// The far end of the surface: the middle of its outer cap, at the height of its farthest point. A mean over the cap,
/// for a single farthest vertex would be one of several on a flat or symmetric end.
Fingertip find_surface_tip(const HandModel& model, const Anatomy& anatomy, const std::vector<std::size_t>& links,
                           const Surface& surface) {
  const double cap = (1 - kTipCap) * surface.extent;
  double cap_area = 0, farthest = -std::numeric_limits<double>::infinity();
  Vector3d moment;
  Fingertip tip;
  for (std::size_t link : links) {
    for_each_triangle(model, anatomy, link, [&](double area, Vector3d centroid, const auto& corners) {
      for (const Vector3d& corner : corners) {
        const double height = dot(corner, surface.direction);
        if (height > farthest) farthest = height, tip.link = static_cast<int>(link);
      }
      if (dot(centroid, surface.direction) < cap) return;
      cap_area += area;
      moment += area * centroid;
    });
  }
  // Long triangles may leave no centroid in the cap: then the finger's own axis marks the tip.
  const Vector3d middle = cap_area > 0 ? moment / cap_area : surface.extent * surface.direction;
  const Vector3d p_joint = orthogonal_part(middle, surface.direction) + surface.extent * surface.direction;
  tip.p_link = anatomy.links[tip.link].T_joint_link.inverse() * p_joint;
  tip.reason = "far end of the surface of " + anatomy.links[tip.link].name;
  tip.confidence = 0.8;
  return tip;
}

/// Links of the last rigid group.
std::vector<std::size_t> links_on(const Anatomy& anatomy, int joint) {
  std::vector<std::size_t> links;
  for (std::size_t i = 0; i < anatomy.links.size(); ++i)
    if (anatomy.links[i].joint == joint) links.push_back(i);
  return links;
}

bool is_leaf(const HandModel& model, int link) {
  return std::none_of(model.links.begin(), model.links.end(),
                      [link](const ModelLink& other) { return other.parent_link == link; });
}

int find_link(const Anatomy& anatomy, const std::string& name) {
  const auto link = std::ranges::find(anatomy.links, name, &ProfileLink::name);
  return link == anatomy.links.end() ? -1 : static_cast<int>(link - anatomy.links.begin());
}

/// A stated point; on a stated link without one the far end of its surface, or its origin when it has none.
Fingertip make_stated_tip(const HandModel& model, const Anatomy& anatomy, const StatedFingertip& stated) {
  Fingertip tip;
  const auto link = static_cast<std::size_t>(find_link(anatomy, stated.link));
  if (!stated.point) {
    const Surface surface = measure_surface(model, anatomy, {link});
    if (surface.extent > 0) tip = find_surface_tip(model, anatomy, {link}, surface);
  } else {
    tip.p_link = *stated.point;
  }
  tip.link = static_cast<int>(link);
  tip.confidence = 1;
  return tip;
}

}  // namespace

std::vector<const StatedFingertip*> find_stated_fingertips(const Anatomy& anatomy, const HandConfig& config) {
  constexpr const char* key = "fingertips";
  std::vector<const StatedFingertip*> tips(anatomy.fingers.size(), nullptr);
  for (const StatedFingertip& stated : config.fingertips) {
    const int link = find_link(anatomy, stated.link);
    if (link < 0) {
      std::vector<std::string_view> known;
      for (const ProfileLink& candidate : anatomy.links)
        if (candidate.joint >= 0) known.push_back(candidate.name);
      refuse_config(config, key, "no finger has a link \"" + stated.link + "\"", did_you_mean(stated.link, known));
    }
    const int joint = anatomy.links[link].joint;
    const auto finger =
        std::ranges::find_if(anatomy.fingers, [joint](const FingerAnatomy& f) { return f.joints.back() == joint; });
    if (finger == anatomy.fingers.end())
      refuse_config(config, key, "the last joint of a finger does not carry \"" + stated.link + "\"",
                    "name a link on the last phalanx, or state \"fingers\" that end there");
    const StatedFingertip*& tip = tips[finger - anatomy.fingers.begin()];
    if (tip)
      refuse_config(config, key, "\"" + tip->link + "\" and \"" + stated.link + "\" are on one finger",
                    "a finger has one tip");
    tip = &stated;
  }
  return tips;
}

Fingertip find_fingertip(const HandModel& model, const Anatomy& anatomy, const FingerAnatomy& finger,
                         const StatedFingertip* stated) {
  if (stated) return make_stated_tip(model, anatomy, *stated);
  const int last_joint = finger.joints.back();
  const std::vector<std::size_t> links = links_on(anatomy, last_joint);
  const Surface surface = measure_surface(model, anatomy, links);

  Fingertip best;
  double best_reach = 0;
  for (std::size_t link : links) {
    if (!is_leaf(model, anatomy.model_links[link])) continue;
    const Vector3d origin = anatomy.links[link].T_joint_link.translation;
    const double reach = surface.extent > 0 ? dot(origin, surface.direction) / surface.extent : norm(origin);
    if (surface.extent > 0 && (reach < kNearestTipFrame || reach > kFarthestTipFrame)) continue;
    if (reach > best_reach) {
      best_reach = reach;
      best.link = static_cast<int>(link);
    }
  }
  if (best.link >= 0) {
    best.reason = "frame " + anatomy.links[best.link].name + " stands at the end of the last phalanx";
    best.confidence = surface.extent > 0 ? 0.95 : 0.75;
    return best;
  }
  if (surface.extent > 0) return find_surface_tip(model, anatomy, links, surface);

  // Neither frame nor surface: a last phalanx as long as the one before it, straight on.
  const Joint& joint = anatomy.tree.joints[last_joint];
  best.link = static_cast<int>(links.front());
  best.p_link = anatomy.links[best.link].T_joint_link.inverse() *
                (joint.T_parent_joint.rotation.transposed() * joint.T_parent_joint.translation);
  best.reason = anatomy.links[best.link].name + " has no geometry; a phalanx as long as the one before is assumed";
  best.confidence = 0.3;
  return best;
}

}  // namespace uhas
