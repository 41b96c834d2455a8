#include "json/evaluation_json.hpp"

#include <cmath>

#include "text/words.hpp"

namespace uhas::tools {
namespace {

/// A greatest distance that no pair has is none.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Quantiles& q) {
  return {{"median", number_or_null(q.median)},
          {"p95", number_or_null(q.p95)},
          {"worst", number_or_null(q.worst)},
          {"count", q.count}};
}

Json to_json(const InputReach& reach) {
  return {{"lower", reach.lower},
          {"upper", reach.upper},
          {"useful_lower", reach.useful_lower},
          {"useful_upper", reach.useful_upper},
          {"achieved_lower", reach.achieved_lower},
          {"achieved_upper", reach.achieved_upper},
          {"followed", reach.followed},
          {"dead", reach.dead}};
}

Json reach_json(const HandProfile& profile, const ReachScore& score) {
  Json fingers = Json::array(), clamped = Json::array();
  for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
    const FingerReach& finger = score.fingers[f];
    fingers.push_back({{"finger", profile.fingers[f].name},
                       {"slots", slot_numbers(profile.fingers[f].slots)},
                       {"delta_theta", to_json(finger.azimuth)},
                       {"delta_r_0", to_json(finger.radial[0])},
                       {"delta_r_1", to_json(finger.radial[1])},
                       {"delta_r_both", to_json(finger.together)}});
  }
  for (const ClampedJoint& joint : score.clamped)
    clamped.push_back({{"joint", profile.tree.joints[joint.joint].name}, {"share", joint.share}});
  return {{"fingers", fingers}, {"joints_at_limit", clamped}};
}

Json fit_json(const HandProfile& profile, const FitScore& score) {
  const auto fit = [](const FingerFit& f) {
    return Json{{"residual", to_json(f.residual)}, {"ratio", to_json(f.ratio)}};
  };
  Json solves = Json::array();
  for (const SolveFit& solve : score.solves) {
    Json fingers = Json::array();
    for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
      Json finger{{"finger", profile.fingers[f].name}};
      finger.update(fit(solve.fingers[f]));
      fingers.push_back(finger);
    }
    solves.push_back({{"rule", solve.solve.rule == CascadeRule::contact ? "contact" : "correspondence"},
                      {"passes", solve.solve.passes},
                      {"pooled", fit(solve.pooled)},
                      {"fingers", fingers}});
  }
  return {{"solves", solves},
          {"optimum", to_json(score.optimum)},
          {"problems", score.problems},
          {"negligible", score.negligible},
          {"unconfirmed", score.unconfirmed}};
}

Json surface_json(const HandProfile& profile, const SurfaceScore& score) {
  Json fingers = Json::array();
  for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
    const FingerSurface& finger = score.fingers[f];
    fingers.push_back({{"finger", profile.fingers[f].name},
                       {"at_rest", to_json(finger.at_rest)},
                       {"deformed", to_json(finger.deformed)},
                       {"phi", {finger.phi_least, finger.phi_greatest}},
                       {"phi_gap", finger.phi_gap}});
  }
  return {{"at_rest", to_json(score.at_rest)},
          {"deformed", to_json(score.deformed)},
          {"coverage", score.coverage},
          {"largest_hole", score.largest_hole},
          {"fingers", fingers}};
}

Json smoothness_json(const HandProfile& profile, const std::vector<SmoothnessScore>& scores) {
  const auto steps = [&](const std::vector<JointStep>& joints) {
    Json list = Json::array();
    for (const JointStep& step : joints)
      list.push_back({{"joint", profile.tree.joints[step.joint].name},
                      {"rate", step.rate},
                      {"finest_rate", step.finest_rate},
                      {"jump", step.jump},
                      {"action", step.action},
                      {"change", step.change}});
    return list;
  };
  Json solves = Json::array();
  for (std::size_t s = 0; s < scores.size(); ++s)
    solves.push_back({{"passes", evaluated_solves()[s].passes},
                      {"delta_r", steps(scores[s].radial)},
                      {"delta_theta", steps(scores[s].azimuth)}});
  return solves;
}

Json collision_json(const HandProfile& profile, const std::optional<CollisionScore>& score) {
  if (!score) return nullptr;
  Json pairs = Json::array();
  for (const PairContacts& pair : score->pairs)
    pairs.push_back(
        {{"links", {profile.links[pair.first].name, profile.links[pair.second].name}}, {"poses", pair.poses}});
  return {{"share", score->share},
          {"at_rest", score->at_rest},
          {"distance", to_json(score->distance)},
          {"least_distance", number_or_null(score->least_distance)},
          {"pairs", pairs}};
}

Json scores_json(const EvaluatedHand& hand) {
  const Evaluation& e = hand.evaluation;
  return {{"hand", hand.profile.hand},
          {"reach", reach_json(hand.profile, e.reach)},
          {"fit", fit_json(hand.profile, e.fit)},
          {"surface", surface_json(hand.profile, e.surface)},
          {"smoothness", smoothness_json(hand.profile, e.smoothness)},
          {"collision", collision_json(hand.profile, e.collision)},
          {"time", {{"median", e.time.median}, {"p99", e.time.p99}}}};
}

}  // namespace

Json evaluation_json(const EvaluationRun& run, std::span<const EvaluatedHand> hands) {
  Json document = new_document("uhas-evaluation");
  document["actions"] = run.options.battery.actions;
  document["radial_bound"] = run.options.battery.radial_bound;
  document["seed"] = run.options.battery.seed;
  document["lines"] = run.options.smoothness_lines;
  document["hands"] = Json::array();
  for (const EvaluatedHand& hand : hands) document["hands"].push_back(scores_json(hand));
  return document;
}

}  // namespace uhas::tools
