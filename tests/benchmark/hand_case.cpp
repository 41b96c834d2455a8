#include "hand_case.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <span>
#include <stdexcept>

#include "support/random_action.hpp"
#include "uhas/profile_builder/build_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"

namespace uhas::benchmark {
namespace {

constexpr double kAnyTheta = 1.0;  // rad; beyond the bounds of most fingers, which clamp it
constexpr std::size_t kStepsBetweenDraws = 25;

/// d r uniform about `middle`, `r` to either side.
std::vector<double> independent_draws(std::mt19937_64& random, std::size_t count, double r, double middle = 0) {
  std::vector<double> actions;
  for (std::size_t n = 0; n < count; ++n) {
    std::vector<double> action = test::random_action(random, kAnyTheta, r);
    for (std::size_t i = kSlotCount; i < action.size(); ++i) action[i] += middle;
    actions.insert(actions.end(), action.begin(), action.end());
  }
  return actions;
}

/// Straight lines from draw to draw, back to the first one at the end.
std::vector<double> smooth_motion(std::mt19937_64& random, std::size_t count, double r) {
  const std::size_t draws = (count + kStepsBetweenDraws - 1) / kStepsBetweenDraws;
  const std::vector<double> knots = independent_draws(random, draws, r);
  const std::size_t size = knots.size() / draws;
  std::vector<double> actions;
  for (std::size_t n = 0; n < count; ++n) {
    const double* from = &knots[n / kStepsBetweenDraws * size];
    const double* to = &knots[(n / kStepsBetweenDraws + 1) % draws * size];
    const double way = double(n % kStepsBetweenDraws) / double(kStepsBetweenDraws);
    for (std::size_t i = 0; i < size; ++i) actions.push_back(from[i] + way * (to[i] - from[i]));
  }
  return actions;
}

ActionSet solved(const HandProfile& profile, std::vector<double> actions, std::size_t count) {
  CascadeSolver<double> solver(profile);
  const FingertipKinematics<double> kinematics(profile);
  const std::size_t size = actions.size() / count, joints = solver.joint_count();
  ActionSet set{std::move(actions), std::vector<double>(count * joints),
                std::vector<double>(3 * count * kinematics.finger_count())};
  for (std::size_t n = 0; n < count; ++n) {
    const Action<double> action{.values = std::span(set.actions).subspan(n * size, size), .driving_vectors_phi = {}};
    if (solver.solve(action, std::span(set.q).subspan(n * joints, joints)) != Status::ok)
      throw std::runtime_error("an action of the benchmark was refused");
  }
  if (kinematics.fingertips_batch(set.q, set.fingertips) != Status::ok)
    throw std::runtime_error("a posture of the benchmark was refused");
  return set;
}

}  // namespace

HandCase make_hand_case(const std::filesystem::path& urdf, std::size_t count, unsigned seed) {
  HandCase hand;
  hand.urdf = urdf;
  hand.profile = build_profile(urdf.string());
  hand.count = count;
  std::mt19937_64 random(seed);
  hand.gentle = solved(hand.profile, independent_draws(random, count, 0.5), count);
  hand.any = solved(hand.profile, independent_draws(random, count, kRadialBound), count);
  hand.closing = solved(hand.profile, independent_draws(random, count, 0.25, -0.75), count);
  hand.trajectory = solved(hand.profile, smooth_motion(random, count, 0.5), count);
  hand.rates.resize(hand.gentle.q.size());
  std::uniform_real_distribution<double> rate(-5, 5);
  std::ranges::generate(hand.rates, [&] { return rate(random); });
  return hand;
}

std::vector<std::filesystem::path> find_hands(const std::filesystem::path& own_hands,
                                              const std::filesystem::path& shared_hands) {
  std::vector<std::filesystem::path> own, shared;
  for (const auto& entry : std::filesystem::directory_iterator(own_hands)) {
    const auto urdf = entry.path() / (entry.path().filename().string() + ".urdf");
    if (exists(urdf)) own.push_back(urdf);
  }
  std::ranges::sort(own);
  if (shared_hands.empty()) return own;

  for (const auto& entry : std::filesystem::directory_iterator(shared_hands)) {
    std::ifstream truth(entry.path() / "truth.json");
    if (truth) shared.push_back(entry.path() / nlohmann::json::parse(truth).at("urdf").get<std::string>());
  }
  if (shared.empty())
    throw std::runtime_error(shared_hands.string() + ": no */truth.json there; name a folder of hands");
  std::ranges::sort(shared);
  own.insert(own.end(), shared.begin(), shared.end());
  return own;
}

}  // namespace uhas::benchmark
