#include "uhas/evaluation/evaluation.hpp"

#include <algorithm>
#include <string>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

void require_at_least(int least, int value, const std::string& option) {
  if (value < least)
    throw Error(ErrorCode::invalid_option, "", option + " is " + std::to_string(value),
                "choose at least " + std::to_string(least));
}

CollisionScore measure_collisions(const HandProfile& profile, const HandGeometry& geometry,
                                  std::span<const std::vector<double>> battery, int threads) {
  const SelfCollision collision(profile, geometry);
  CascadeSolver<double> solver(profile);
  const std::size_t joints = profile.tree.joints.size();
  std::vector<double> poses(battery.size() * joints), rest;
  for (std::size_t n = 0; n < battery.size(); ++n)
    solver.solve({.values = battery[n]}, std::span(poses).subspan(n * joints, joints));
  for (const JointTraits& traits : profile.joint_traits) rest.push_back(traits.q_sphere);

  const BatteryCollisions found = battery_collisions(collision, poses, threads);
  CollisionScore score;
  score.share = static_cast<double>(found.colliding) / static_cast<double>(battery.size());
  score.at_rest = collision.collides(rest);
  std::vector<double> distances;
  for (const NearestLinks& nearest : found.nearest) distances.push_back(nearest.distance);
  score.least_distance = *std::ranges::min_element(distances);
  score.distance = quantiles(std::move(distances));
  score.pairs = found.pairs;
  return score;
}

}  // namespace

std::vector<SolveOptions> evaluated_solves() {
  std::vector<SolveOptions> solves;
  for (int passes : {1, 2, 3, 10}) solves.push_back({.passes = passes});
  solves.push_back({.rule = CascadeRule::contact});
  return solves;
}

Evaluation evaluate_hand(const HandProfile& profile, const HandGeometry* geometry, const EvaluationOptions& options) {
  require_at_least(1, options.battery.actions, "actions");
  require_at_least(0, options.smoothness_lines, "smoothness_lines");
  require_at_least(1, options.threads, "threads");
  const std::vector<std::vector<double>> battery = random_battery(profile, options.battery);

  Evaluation evaluation;
  evaluation.reach = measure_reach(profile, battery);
  evaluation.fit = measure_fit(profile, battery, evaluated_solves(), options.threads);
  evaluation.surface = measure_surface(profile, battery, options.threads);
  for (const SolveOptions& solve : evaluated_solves()) {
    if (solve.rule != CascadeRule::correspondence) continue;
    evaluation.smoothness.push_back(measure_smoothness(
        profile,
        {.lines = options.smoothness_lines, .seed = options.battery.seed, .threads = options.threads, .solve = solve}));
  }
  if (geometry != nullptr) evaluation.collision = measure_collisions(profile, *geometry, battery, options.threads);
  evaluation.time = measure_solve_time(profile, battery);
  return evaluation;
}

}  // namespace uhas
