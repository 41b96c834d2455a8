#include "uhas/anatomy/fingers/fingertip.hpp"

#include <algorithm>
#include <array>
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
void for_each_triangle(const HandModel& model, const PalmTree& palm, std::size_t link, Visit visit) {
  const TriangleMesh& mesh = model.links[palm.model_links[link]].mesh;
  const RigidTransformd& T_joint_link = palm.links[link].T_joint_link;
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

Surface measure_surface(const HandModel& model, const PalmTree& palm, const std::vector<std::size_t>& links) {
  // direction: from the joint toward the surface's centroid
  Surface surface;
  Vector3d moment;
  for (std::size_t link : links) {
    for_each_triangle(model, palm, link, [&](double area, Vector3d centroid, const auto&) {
      surface.area += area;
      moment += area * centroid;
    });
  }
  if (!(surface.area > 0)) return surface;
  surface.direction = normalized(moment / surface.area);

  // extent: its farthest corner that way
  for (std::size_t link : links) {
    for_each_triangle(model, palm, link, [&](double, Vector3d, const auto& corners) {
      for (const Vector3d& corner : corners) surface.extent = std::max(surface.extent, dot(corner, surface.direction));
    });
  }
  return surface;
}

/// The far end of the surface: the middle of its outer cap, at the height of its farthest point. A mean over the cap,
/// for a single farthest vertex would be one of several on a flat or symmetric end.
Fingertip find_surface_tip(const HandModel& model, const PalmTree& palm, const std::vector<std::size_t>& links,
                           const Surface& surface) {
  // the centroid of the triangles in the cap, and the link with the farthest corner
  const double cap = (1 - kTipCap) * surface.extent;
  double cap_area = 0, farthest = -std::numeric_limits<double>::infinity();
  Vector3d moment;
  Fingertip tip;
  for (std::size_t link : links) {
    for_each_triangle(model, palm, link, [&](double area, Vector3d centroid, const auto& corners) {
      for (const Vector3d& corner : corners) {
        const double height = dot(corner, surface.direction);
        if (height > farthest) farthest = height, tip.link = static_cast<int>(link);
      }
      if (dot(centroid, surface.direction) < cap) return;
      cap_area += area;
      moment += area * centroid;
    });
  }

  // moved out to the farthest corner's height; long triangles may leave no centroid in the cap: then the axis from the
  // joint to the surface's centroid marks the tip
  const Vector3d middle = cap_area > 0 ? moment / cap_area : surface.extent * surface.direction;
  const Vector3d p_joint = orthogonal_part(middle, surface.direction) + surface.extent * surface.direction;
  tip.p_link = palm.links[tip.link].T_joint_link.inverse() * p_joint;
  tip.reason = "far end of the surface of " + palm.links[tip.link].name;
  tip.confidence = 0.8;
  return tip;
}

/// Links of the rigid group that `joint` carries.
std::vector<std::size_t> links_on(const PalmTree& palm, int joint) {
  std::vector<std::size_t> links;
  for (std::size_t i = 0; i < palm.links.size(); ++i)
    if (palm.links[i].joint == joint) links.push_back(i);
  return links;
}

bool is_leaf(const HandModel& model, int link) {
  return std::none_of(model.links.begin(), model.links.end(),
                      [link](const ModelLink& other) { return other.parent_link == link; });
}

int find_link(const PalmTree& palm, const std::string& name) {
  const auto link = std::ranges::find(palm.links, name, &ProfileLink::name);
  return link == palm.links.end() ? -1 : static_cast<int>(link - palm.links.begin());
}

/// A stated point; on a stated link without one the far end of its surface, or its origin when it has none.
Fingertip make_stated_tip(const HandModel& model, const PalmTree& palm, const StatedFingertip& stated) {
  Fingertip tip;
  const auto link = static_cast<std::size_t>(find_link(palm, stated.link));
  if (!stated.point) {
    const Surface surface = measure_surface(model, palm, {link});
    if (surface.extent > 0) tip = find_surface_tip(model, palm, {link}, surface);
  } else {
    tip.p_link = *stated.point;
  }
  tip.link = static_cast<int>(link);
  tip.pad_normal = stated.pad_normal;
  tip.reason = kStatedInConfig;
  tip.confidence = 1;
  return tip;
}

/// What the config states of each finger's tip, checked; null where it states nothing.
std::vector<const StatedFingertip*> find_stated_fingertips(const PalmTree& palm, const HandConfig& config) {
  constexpr const char* key = "fingertips";
  std::vector<const StatedFingertip*> tips(palm.chains.size(), nullptr);
  for (const StatedFingertip& stated : config.fingertips) {
    const int link = find_link(palm, stated.link);
    if (link < 0) {
      std::vector<std::string_view> known;
      for (const ProfileLink& candidate : palm.links)
        if (candidate.joint >= 0) known.push_back(candidate.name);
      refuse_config(config, key, "no finger has a link \"" + stated.link + "\"", did_you_mean(stated.link, known));
    }
    const int joint = palm.links[link].joint;
    const auto finger =
        std::ranges::find_if(palm.chains, [joint](const std::vector<int>& chain) { return chain.back() == joint; });
    if (finger == palm.chains.end())
      refuse_config(config, key, "the last joint of a finger does not carry \"" + stated.link + "\"",
                    "name a link on the last phalanx, or state \"fingers\" that end there");
    const StatedFingertip*& tip = tips[finger - palm.chains.begin()];
    if (tip)
      refuse_config(config, key, "\"" + tip->link + "\" and \"" + stated.link + "\" are on one finger",
                    "a finger has one tip");
    tip = &stated;
  }
  return tips;
}

/// Of the frames without links beyond them, the one farthest out: where the surface ends, or anywhere beyond the joint
/// when there is none. Nothing when no frame stands there.
std::optional<Fingertip> find_tip_frame(const HandModel& model, const PalmTree& palm,
                                        const std::vector<std::size_t>& links, const Surface& surface) {
  Fingertip best;
  double best_reach = 0;
  for (std::size_t link : links) {
    if (!is_leaf(model, palm.model_links[link])) continue;
    const Vector3d origin = palm.links[link].T_joint_link.translation;
    const double reach = surface.extent > 0 ? dot(origin, surface.direction) / surface.extent : norm(origin);
    if (surface.extent > 0 && (reach < kNearestTipFrame || reach > kFarthestTipFrame)) continue;
    if (reach > best_reach) {
      best_reach = reach;
      best.link = static_cast<int>(link);
    }
  }
  if (best.link < 0) return std::nullopt;
  best.reason = "frame " + palm.links[best.link].name + " stands at the end of the last phalanx";
  best.confidence = surface.extent > 0 ? 0.95 : 0.75;
  return best;
}

/// Neither frame nor surface: a last phalanx as long as the one before it, straight on.
Fingertip assume_tip(const PalmTree& palm, int last_joint, std::size_t link) {
  const Joint& joint = palm.tree.joints[last_joint];
  Fingertip tip;
  tip.link = static_cast<int>(link);
  tip.p_link = palm.links[link].T_joint_link.inverse() *
               (joint.T_parent_joint.rotation.transposed() * joint.T_parent_joint.translation);
  tip.reason = palm.links[link].name + " has no geometry; a phalanx as long as the one before is assumed";
  tip.confidence = 0.3;
  return tip;
}

Fingertip find_fingertip(const HandModel& model, const PalmTree& palm, int last_joint) {
  const std::vector<std::size_t> links = links_on(palm, last_joint);
  const Surface surface = measure_surface(model, palm, links);
  if (const std::optional<Fingertip> tip = find_tip_frame(model, palm, links, surface)) return *tip;
  if (surface.extent > 0) return find_surface_tip(model, palm, links, surface);
  return assume_tip(palm, last_joint, links.front());
}

}  // namespace

std::vector<Fingertip> find_fingertips(const HandModel& model, const PalmTree& palm, const HandConfig& config) {
  const std::vector<const StatedFingertip*> stated = find_stated_fingertips(palm, config);
  std::vector<Fingertip> tips;
  for (std::size_t i = 0; i < palm.chains.size(); ++i)
    tips.push_back(stated[i] ? make_stated_tip(model, palm, *stated[i])
                             : find_fingertip(model, palm, palm.chains[i].back()));
  return tips;
}

HandFinding explain_fingertips(std::span<const Fingertip> tips) {
  HandFinding finding{"fingertips", "one a finger", kStatedInConfig, 1};
  for (const Fingertip& tip : tips) {
    if (!(tip.confidence < finding.confidence)) continue;
    finding.reason = tip.reason;
    finding.confidence = tip.confidence;
  }
  return finding;
}

}  // namespace uhas
