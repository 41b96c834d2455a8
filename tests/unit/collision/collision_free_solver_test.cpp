// Judged without FCL: the toy hand's links are boxes, and every pair of triangles is looked at.
#include "uhas/collision/collision_free_solver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "support/mesh_contact.hpp"
#include "support/random_action.hpp"
#include "support/sliding_boxes.hpp"
#include "support/toy_hand.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/profile_builder/build_stages.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

struct Hand {
  explicit Hand(const HandModel& model)
      : stages(run_stages(model, {}, BuildStage::correspondences)),
        profile(make_profile(stages, {})),
        geometry(hand_geometry(profile, stages.model, "")),
        collision(profile, geometry) {}

  BuildStages stages;
  HandProfile profile;
  HandGeometry geometry;
  SelfCollision collision;
};

const Hand& toy() {
  static const Hand hand(make_toy_hand());
  return hand;
}

std::vector<double> solve(const Hand& hand, const std::vector<double>& action) {
  CascadeSolver<double> solver(hand.profile);
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve({.values = action}, q) == Status::ok);
  return q;
}

bool collides(const Hand& hand, const std::vector<double>& q) {
  const std::vector<RigidTransformd> T_palm_link = link_poses(hand.profile.tree, hand.profile.links, q);
  const auto placed = [&](int link) { return PlacedMesh(hand.geometry.links[link], T_palm_link[link]); };
  for (const LinkPair& pair : hand.collision.pairs()) {
    if (pair.use == LinkPairUse::adjacent || pair.use == LinkPairUse::touching) continue;
    const PlacedMesh a = placed(pair.first), b = placed(pair.second);
    if (meshes_cross(a, b) || is_inside(a.triangles[0].corners[0], b) || is_inside(b.triangles[0].corners[0], a))
      return true;
  }
  return false;
}

std::vector<double> scaled(const std::vector<double>& action, double scale) {
  std::vector<double> result;
  for (const double value : action) result.push_back(scale * value);
  return result;
}

/// Within the bounds of every input, so that nothing is clamped.
std::vector<double> random_action_within_bounds(const HandProfile& profile, std::mt19937_64& random) {
  std::vector<double> action = random_action(random, 1, 2);
  for (int slot = 0; slot < kSlotCount; ++slot) {
    double bound = 0;
    for (const ProfileFinger& finger : profile.fingers)
      if (finger.slots[slot] && finger.lateral_table >= 0) {
        const LateralTable& table = profile.lateral_tables[finger.lateral_table];
        bound = std::min(-table.delta_theta_lower, table.delta_theta_upper);
      }
    action[slot] *= bound;
  }
  return action;
}

}  // namespace

TEST_CASE("what collides is scaled back to where it is about to, what is free is kept") {
  const Hand& hand = toy();
  REQUIRE_FALSE(collides(hand, solve(hand, std::vector<double>(15, 0.0))));
  CollisionFreeSolver solver(hand.profile, {}, hand.collision);
  std::mt19937_64 random(1);
  int free = 0, taken_back = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const std::vector<double> action = random_action_within_bounds(hand.profile, random), wanted = solve(hand, action);
    std::vector<double> q(wanted.size());
    SolveReport report;
    const CollisionFreeSolution solution = solver.solve({.values = action}, q, report);
    REQUIRE(solution.status == Status::ok);
    REQUIRE(solution.scale);
    if (!collides(hand, wanted)) {
      ++free;
      CHECK(*solution.scale == 1);
      CHECK(q == wanted);
      CHECK(solution.values == action);
      continue;
    }
    ++taken_back;
    const double scale = *solution.scale;
    CHECK(scale < 1);
    CHECK_FALSE(collides(hand, q));
    CHECK(q == solve(hand, scaled(action, scale)));
    CHECK(solution.values == scaled(action, scale));
    for (int step = 0; step / 32.0 <= scale; ++step)
      CHECK_FALSE(collides(hand, solve(hand, scaled(action, step / 32.0))));
    CHECK(collides(hand, solve(hand, scaled(action, scale + 1 / 32768.0))));
  }
  CHECK(free > 5);
  CHECK(taken_back > 5);
}

TEST_CASE("the report is of the solution, of a solver that was moved too") {
  const Hand& hand = toy();
  CollisionFreeSolver made(hand.profile, {}, hand.collision), solver(std::move(made));
  CascadeSolver<double> plain(hand.profile);
  std::mt19937_64 random(2);
  std::vector<double> q(plain.joint_count()), again(plain.joint_count());
  int taken_back = 0;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> action = random_action_within_bounds(hand.profile, random);
    SolveReport report, expected;
    const CollisionFreeSolution solution = solver.solve({.values = action}, q, report);
    REQUIRE(solution.scale);
    taken_back += *solution.scale < 1;
    REQUIRE(plain.solve({.values = scaled(action, *solution.scale)}, again, expected) == Status::ok);
    CHECK(report.residual_rms == expected.residual_rms);
  }
  CHECK(taken_back > 0);
}

TEST_CASE("a hand that collides undeformed gets what was asked for") {
  Hand hand(make_toy_hand());
  for (std::size_t i = 0; i < hand.profile.links.size(); ++i)
    if (hand.profile.links[i].name == "palm")  // a wall in the way of the first finger
      hand.geometry.links[i] = merged(hand.geometry.links[i], make_box({0, 0.022, 0.15}, {0.2, 0.01, 0.1}));
  const HandProfile& profile = hand.profile;
  const SelfCollision collision(profile, hand.geometry, {.touching_share = 1});
  CollisionFreeSolver solver(profile, {}, collision);
  CascadeSolver<double> plain(profile);
  const std::vector<double> action(15, -0.1);
  std::vector<double> q(plain.joint_count()), expected(plain.joint_count());
  REQUIRE(plain.solve({.values = action}, expected) == Status::ok);
  SolveReport report;
  const CollisionFreeSolution solution = solver.solve({.values = action}, q, report);
  CHECK(solution.status == Status::ok);
  CHECK_FALSE(solution.scale);
  CHECK(q == expected);
}

TEST_CASE("an action that cannot be solved is refused, and nothing is touched") {
  const Hand& hand = toy();
  CollisionFreeSolver solver(hand.profile, {}, hand.collision);
  std::vector<double> action(15, 0.0), q(hand.profile.tree.joints.size(), 7.0);
  action[3] = std::numeric_limits<double>::quiet_NaN();
  SolveReport report;
  CHECK(solver.solve({.values = action}, q, report).status == Status::non_finite_input);
  CHECK(q == std::vector<double>(q.size(), 7.0));
}
