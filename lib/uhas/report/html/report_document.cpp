#include "uhas/report/html/report_document.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "uhas/base/errors.hpp"
#include "uhas/base/homogeneous_matrix.hpp"
#include "uhas/geometry/simplified_geometry.hpp"
#include "uhas/json/json_text.hpp"
#include "uhas/profile_io/flat_profile.hpp"
#include "uhas/report/html/base64.hpp"
#include "uhas/report/html/embedded_files.hpp"

namespace uhas {
namespace {

constexpr std::size_t kMostTriangles = 40'000;  // of a hand
constexpr std::size_t kMostPoints = 6'000;
constexpr int kDefaultDrivingVectors = 2;

void append(std::vector<float>& numbers, Vector3d v) {
  for (const double number : {v.x, v.y, v.z}) numbers.push_back(static_cast<float>(number));
}

/// What solving and posing take, and no more.
HandProfile solvable_part(HandProfile profile) {
  std::erase_if(profile.correspondences, [](const Correspondence& point) { return point.weight <= 0; });
  profile.findings.clear();
  profile.warnings.clear();
  profile.settings_json.clear();
  profile.sources.clear();
  return profile;
}

Json links_json(const HandProfile& profile) {
  Json links = Json::array();
  for (const ProfileLink& link : profile.links) links.push_back({{"name", link.name}, {"joint", link.joint}});
  return links;
}

Json meshes_json(const HandGeometry& geometry) {
  Json meshes = Json::array();
  const HandGeometry simplified = simplified_geometry(geometry, kMostTriangles);
  for (std::size_t i = 0; i < simplified.links.size(); ++i) {
    const TriangleMesh& mesh = simplified.links[i];
    if (mesh.triangles.empty()) continue;
    std::vector<float> vertices;
    for (const Vector3d& vertex : mesh.vertices) append(vertices, vertex);
    std::vector<std::uint32_t> triangles;
    for (const auto& triangle : mesh.triangles) triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    meshes.push_back(
        {{"link", i}, {"vertices", base64_of_numbers(vertices)}, {"triangles", base64_of_numbers(triangles)}});
  }
  return meshes;
}

Json findings_json(const HandProfile& profile) {
  Json findings = Json::array();
  for (const HandFinding& finding : profile.findings)
    findings.push_back({{"item", finding.item},
                        {"value", finding.value},
                        {"reason", finding.reason},
                        {"confidence", finding.confidence}});
  return findings;
}

/// Fingertips, in the order of the fingers.
Json tips_json(const HandProfile& profile) {
  Json tips = Json::array();
  for (const ProfileFinger& finger : profile.fingers)
    tips.push_back({{"link", finger.tip_link}, {"position", to_json(finger.p_tip_link)}});
  return tips;
}

/// Where each joint turns or slides: its axis, in the frame of a link that it carries.
Json joints_json(const HandProfile& profile) {
  constexpr std::array kinds{"revolute", "continuous", "prismatic"};
  Json joints = Json::array();
  for (int i = 0; i < static_cast<int>(profile.tree.joints.size()); ++i) {
    const Joint& joint = profile.tree.joints[i];
    const auto link = std::ranges::find(profile.links, i, &ProfileLink::joint);
    if (link == profile.links.end())
      throw Error(ErrorCode::invalid_profile, "",
                  "joint " + joint.name + " carries no link, so that it has no place to be drawn at",
                  "rebuild it with uhas-build-profile");
    const RigidTransformd T_link_joint = link->T_joint_link.inverse();
    joints.push_back({{"kind", kinds[static_cast<std::size_t>(joint.kind)]},
                      {"link", link - profile.links.begin()},
                      {"origin", to_json(T_link_joint.translation)},
                      {"axis", to_json(T_link_joint.rotation * joint.axis)}});
  }
  return joints;
}

/// All correspondences or, where they are too many, an even choice in the order of the profile.
Json points_json(const HandProfile& profile) {
  const std::size_t count = profile.correspondences.size(), kept = std::min(count, kMostPoints);
  std::vector<std::int32_t> link;
  std::vector<float> position, theta, phi, rho;
  for (std::size_t i = 0; i < kept; ++i) {
    const Correspondence& point = profile.correspondences[i * count / kept];
    link.push_back(point.link);
    append(position, point.p_link);
    theta.push_back(static_cast<float>(point.theta));
    phi.push_back(static_cast<float>(point.phi));
    rho.push_back(static_cast<float>(point.rho));
  }
  return {{"link", base64_of_numbers(link)},
          {"position", base64_of_numbers(position)},
          {"theta", base64_of_numbers(theta)},
          {"phi", base64_of_numbers(phi)},
          {"rho", base64_of_numbers(rho)}};
}

Json tables_json(const HandProfile& profile) {
  Json tables = Json::array();
  for (int i = 0; i < static_cast<int>(profile.lateral_tables.size()); ++i) {
    const LateralTable& table = profile.lateral_tables[i];
    const auto has_joint = [&](const ProfileFinger& finger) {
      return std::ranges::find(finger.joints, table.joint) != finger.joints.end();
    };
    const auto finger = std::ranges::find_if(profile.fingers, has_joint);
    tables.push_back(
        {{"joint", profile.tree.joints[table.joint].name},
         {"finger", finger == profile.fingers.end() ? Json() : Json(finger->name)},
         {"driving", std::ranges::find(profile.fingers, i, &ProfileFinger::lateral_table) != profile.fingers.end()},
         {"q", table.q},
         {"theta", table.theta},
         {"neutral", table.neutral},
         {"theta_initial", table.theta_initial},
         {"delta_theta_range", {table.delta_theta_lower, table.delta_theta_upper}}});
  }
  return tables;
}

struct Bounds {
  double lower = 0, upper = 0;
};

/// Of a slot's delta theta: the ends of its finger's table.
std::array<Bounds, kSlotCount> delta_theta_bounds(const HandProfile& profile) {
  std::array<Bounds, kSlotCount> bounds;
  for (const ProfileFinger& finger : profile.fingers)
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (finger.slots[slot] && finger.lateral_table >= 0) {
        const LateralTable& table = profile.lateral_tables[finger.lateral_table];
        bounds[slot] = {table.delta_theta_lower, table.delta_theta_upper};
      }
  return bounds;
}

/// Azimuth of each slot's driving plane.
std::array<double, kSlotCount> planes(const HandProfile& profile) {
  std::array<double, kSlotCount> azimuths{};
  for (const ProfileFinger& finger : profile.fingers)
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (finger.slots[slot]) azimuths[slot] = finger.theta_initial;
  return azimuths;
}

std::vector<double> default_driving_vectors(int count) {
  std::vector<double> phi;
  for (int j = 1; j <= count; ++j) phi.push_back(std::numbers::pi * j / (count + 1));
  return phi;
}

/// An action in [-1, 1] in radians and sphere radii.
std::vector<double> denormalized(std::vector<double> action, const std::array<Bounds, kSlotCount>& bounds) {
  for (std::size_t i = 0; i < action.size(); ++i) {
    const Bounds& bound = i < kSlotCount ? bounds[i] : Bounds{-kRadialBound, kRadialBound};
    action[i] *= action[i] < 0 ? -bound.lower : bound.upper;
  }
  return action;
}

Json names_where(const HandProfile& profile, const std::vector<std::uint8_t>& flags) {
  Json names = Json::array();
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i] != 0) names.push_back(profile.tree.joints[i].name);
  return names;
}

/// As the page's solver takes them.
Json options_json(const ReportTimeline& timeline) {
  const SolveOptions& options = timeline.options;
  Json document{{"rule", options.rule == CascadeRule::contact ? "contact" : "correspondence"},
                {"closing", options.closing == CascadeClosing::hard ? "hard" : "fade"},
                {"field", options.field == FieldReading::field ? "field" : "finger"},
                {"passes", options.passes}};
  if (!timeline.driving_vectors_phi.empty()) document["driving_vectors_phi"] = timeline.driving_vectors_phi;
  return document;
}

Json timeline_json(const HandProfile& profile, const ReportTimeline& timeline) {
  CascadeSolver<double> solver(profile, timeline.options);
  std::vector<double> q(profile.tree.joints.size());
  std::vector<std::uint8_t> at_limit(q.size()), closed(q.size());
  SolveReport report{.residual_rms = 0, .at_limit = at_limit, .closed = closed};
  const auto bounds = delta_theta_bounds(profile);

  Json actions = Json::array(), qs = Json::array(), residuals = Json::array(), limited = Json::array(),
       shut = Json::array();
  for (const std::vector<double>& values : timeline.actions) {
    const std::vector<double> action = timeline.normalized ? denormalized(values, bounds) : values;
    const Status status =
        solver.solve({.values = action, .driving_vectors_phi = timeline.driving_vectors_phi}, q, report);
    if (status != Status::ok)
      throw Error(ErrorCode::invalid_action, "", "action " + std::to_string(actions.size()) + ": " + to_string(status),
                  "");
    actions.push_back(action);
    qs.push_back(q);
    residuals.push_back(report.residual_rms);
    limited.push_back(names_where(profile, at_limit));
    shut.push_back(names_where(profile, closed));
  }
  return {{"actions", actions},  {"q", qs},        {"residual_rms", residuals},
          {"at_limit", limited}, {"closed", shut}, {"options", options_json(timeline)}};
}

/// The driving vectors that the page starts with: the timeline's.
std::vector<double> driving_vectors_phi(const std::optional<ReportTimeline>& timeline) {
  if (!timeline || timeline->actions.empty()) return default_driving_vectors(kDefaultDrivingVectors);
  if (!timeline->driving_vectors_phi.empty()) return timeline->driving_vectors_phi;
  return default_driving_vectors(static_cast<int>(timeline->actions.front().size()) / kSlotCount - 1);
}

Json hand_json(const ReportHand& hand) {
  const HandProfile& profile = hand.profile;
  const bool has_actions = hand.timeline && !hand.timeline->actions.empty();
  validate_profile(profile, "");
  Json bounds = Json::array();
  for (const Bounds& bound : delta_theta_bounds(profile)) bounds.push_back({bound.lower, bound.upper});
  return {{"summary", Json::parse(hand.summary_json)},
          {"image", base64(flatten_profile(solvable_part(profile)))},
          {"links", links_json(profile)},
          {"joints", joints_json(profile)},
          {"tips", tips_json(profile)},
          {"findings", findings_json(profile)},
          {"meshes", meshes_json(hand.geometry)},
          {"points", points_json(profile)},
          {"tables", tables_json(profile)},
          {"delta_theta_bounds", bounds},
          {"planes", planes(profile)},
          {"driving_vectors_phi", driving_vectors_phi(hand.timeline)},
          {"palm_normal_palm", to_json(profile.T_palm_sphere.rotation.column(2))},
          {"T_palm_sphere", homogeneous_matrix(profile.T_palm_sphere)},
          {"radius", profile.radius},
          {"mirrored", profile.mirrored},
          {"timeline", has_actions ? timeline_json(profile, *hand.timeline) : Json()},
          {"evaluation", hand.evaluation_json.empty() ? Json() : Json::parse(hand.evaluation_json)}};
}

}  // namespace

std::string report_document(const std::string& title, const std::vector<ReportHand>& hands) {
  Json document{{"format", "uhas-report"}, {"version", 1}, {"title", title}, {"wasm", base64(embedded_hand_module())}};
  document["hands"] = Json::array();
  for (const ReportHand& hand : hands) document["hands"].push_back(hand_json(hand));
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace uhas
