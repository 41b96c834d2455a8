// The sphere controller on the small profile: a joint that mimics another, a sliding joint, a continuous one.
#include "uhas/runtime/sphere_controller.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/joint_groups.hpp"

using namespace uhas;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaster = 1, kFollower = 2;

/// Every joint states a velocity limit; the follower's is the one that binds its group.
HandProfile limited_profile() {
  HandProfile profile = test::small_profile();
  const double limits[] = {3, 2, 0.5, 1, 0.01};
  for (std::size_t i = 0; i < 5; ++i) profile.tree.joints[i].velocity_limit = limits[i];
  return profile;
}

HandProfile unlimited_profile() {
  HandProfile profile = test::small_profile();
  for (Joint& joint : profile.tree.joints) joint.velocity_limit = 0;
  return profile;
}

std::vector<double> solve(const HandProfile& profile, const std::vector<double>& action) {
  CascadeSolver<double> solver(profile);
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve({.values = action, .driving_vectors_phi = {}}, q) == Status::ok);
  return q;
}

Status update(SphereController<double>& controller, const std::vector<double>& action, double dt,
              std::vector<double>& targets) {
  return controller.update({.values = action, .driving_vectors_phi = {}}, dt, targets);
}

bool keeps_mimic(const HandProfile& profile, const std::vector<double>& q) {
  const Joint& follower = profile.tree.joints[kFollower];
  return std::abs(q[kFollower] - follower.mimic_multiplier * q[kMaster] - follower.mimic_offset) < 1e-12;
}

}  // namespace

TEST_CASE("smoothing is the exact exponential, however the time is cut into periods") {
  const HandProfile profile = unlimited_profile();
  SphereController<double> controller(profile, {.time_constant = 0.2});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> period(0.001, 0.1);
  const std::vector<double> start = reference_posture(profile), action = test::random_action(random, 0.3, 0.5);
  const std::vector<double> goal = solve(profile, action);

  std::vector<double> targets(start.size());
  REQUIRE(controller.reset(start, targets) == Status::ok);
  double time = 0;
  for (int n = 0; n < 40; ++n) {
    const double dt = period(random);
    time += dt;
    REQUIRE(update(controller, action, dt, targets) == Status::ok);
    for (std::size_t i = 0; i < goal.size(); ++i)
      CHECK(std::abs(targets[i] - (goal[i] + (start[i] - goal[i]) * std::exp(-time / 0.2))) < 1e-12);
  }
  CHECK(time > 1);
}

TEST_CASE("without smoothing and limits the targets are the solution at once") {
  const HandProfile profile = unlimited_profile();
  SphereController<double> controller(profile);
  std::mt19937_64 random(2);
  const std::vector<double> action = test::random_action(random, 0.3, 1);
  std::vector<double> targets = reference_posture(profile);
  REQUIRE(update(controller, action, 1e-3, targets) == Status::ok);
  const std::vector<double> goal = solve(profile, action);
  for (std::size_t i = 0; i < goal.size(); ++i) CHECK(std::abs(targets[i] - goal[i]) < 1e-15);
}

TEST_CASE("no joint exceeds its velocity limit, followers included, and each uses it") {
  const HandProfile profile = limited_profile();
  for (double scale : {0.3, 1.0}) {
    SphereController<double> controller(profile, {.velocity_scale = scale, .time_constant = 0.01});
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> period(0.001, 0.1);
    std::vector<double> targets = reference_posture(profile), before, fastest(targets.size());
    for (int n = 0; n < 5000; ++n) {
      before = targets;
      const double dt = period(random);
      REQUIRE(update(controller, test::random_action(random, 1, 2.5), dt, targets) == Status::ok);
      for (std::size_t i = 0; i < targets.size(); ++i) {
        const double speed = std::abs(targets[i] - before[i]) / dt / profile.tree.joints[i].velocity_limit;
        fastest[i] = std::max(fastest[i], speed);
        CHECK(speed <= scale * (1 + 1e-9));
      }
      CHECK(keeps_mimic(profile, targets));
    }
    for (std::size_t i = 0; i < fastest.size(); ++i)
      if (static_cast<int>(i) != kMaster) CHECK(fastest[i] == doctest::Approx(scale));
    // the follower turns 0.8 times as far as its master, whose own limit it keeps out of reach
    CHECK(fastest[kMaster] == doctest::Approx(scale * 0.5 / 0.8 / 2));
  }
}

TEST_CASE("goals stay in the middle share of each range and reach its ends") {
  const HandProfile profile = unlimited_profile();
  SphereController<double> controller(profile, {.range_scale = 0.5});
  std::vector<double> action(15, 0.0), targets = reference_posture(profile);
  std::fill(action.begin() + 5, action.end(), -2.0);
  REQUIRE(update(controller, action, 0.01, targets) == Status::ok);
  CHECK(targets[kMaster] == doctest::Approx(0.7 + 0.45));  // closes at 1.6; the range is -0.2 .. 1.6
  CHECK(targets[4] == doctest::Approx(0.01 + 0.005));      // 0 .. 0.02 m
  CHECK(keeps_mimic(profile, targets));

  std::mt19937_64 random(4);
  for (int n = 0; n < 1000; ++n) {
    REQUIRE(update(controller, test::random_action(random, 1, 3), 0.01, targets) == Status::ok);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Joint& joint = profile.tree.joints[i];
      if (joint.mimic_master >= 0) continue;
      const double from_middle = std::abs(targets[i] - (joint.lower + joint.upper) / 2);
      CHECK(from_middle <= (joint.upper - joint.lower) / 4 * (1 + 1e-12));
    }
  }
}

TEST_CASE("a reset takes the measured posture, within limits and without what followers say") {
  const HandProfile profile = limited_profile();
  SphereController<double> controller(profile);
  std::vector<double> targets(5, 7.0);
  REQUIRE(controller.reset(std::vector<double>{0.2, 0.6, kNan, -3, 0.5}, targets) == Status::ok);
  CHECK(targets[0] == 0.2);
  CHECK(targets[1] == 0.6);
  CHECK(targets[2] == doctest::Approx(0.8 * 0.6 + 0.05));
  CHECK(targets[3] == -1);
  CHECK(targets[4] == 0.02);

  const std::vector<double> held = targets;
  CHECK(controller.reset(std::vector<double>{0.2, kInfinity, 0, 0, 0}, targets) == Status::non_finite_input);
  CHECK(controller.reset(std::vector<double>(4, 0.0), targets) == Status::wrong_size);
  CHECK(controller.reset(std::vector<double>(5, 0.0), std::span(targets).first(4)) == Status::wrong_size);
  CHECK(targets == held);
}

TEST_CASE("a bad action or period holds the targets and is named") {
  SphereController<double> controller(limited_profile(), {.time_constant = 0.1});
  const std::vector<double> start = reference_posture(limited_profile()), good(15, -0.3);
  std::vector<double> targets = start, bad = good;
  bad[7] = kNan;
  CHECK(update(controller, bad, 0.01, targets) == Status::non_finite_input);
  bad[7] = -kInfinity;
  CHECK(update(controller, bad, 0.01, targets) == Status::non_finite_input);
  CHECK(update(controller, std::vector<double>(14, 0.0), 0.01, targets) == Status::wrong_size);
  for (double dt : {0.0, -0.01, kNan, kInfinity, -kInfinity})
    CHECK(update(controller, good, dt, targets) == Status::invalid_period);
  CHECK(targets == start);

  std::vector<double> lost = start;
  lost[0] = kNan;
  CHECK(update(controller, good, 0.01, lost) == Status::non_finite_input);
  CHECK(lost[1] == start[1]);
  CHECK(controller.update({.values = good, .driving_vectors_phi = {}}, 0.01, std::span(targets).first(4)) ==
        Status::wrong_size);
  CHECK(update(controller, good, 0.01, targets) == Status::ok);
  CHECK(targets != start);
}

TEST_CASE("whatever comes, targets stay finite and within limits") {
  const HandProfile profile = limited_profile();
  SphereController<double> controller(profile, {.velocity_scale = 5, .time_constant = 0.05});
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(-300, 300), unit(-1, 1);
  std::vector<double> targets(5);
  for (int n = 0; n < 100000; ++n) {
    if (n % 1000 == 0)  // any finite numbers are a state
      for (double& target : targets) target = unit(random) * std::pow(10, exponent(random));
    std::vector<double> action = test::random_action(random, 1, 2.5);
    if (n % 3 == 0)
      for (double& value : action) value *= std::pow(10, exponent(random));
    const double dt = n % 2 ? 0.01 : std::pow(10, exponent(random));
    REQUIRE(update(controller, action, dt, targets) == Status::ok);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Joint& joint = profile.tree.joints[i];
      CHECK(std::isfinite(targets[i]));
      if (joint.mimic_master < 0) CHECK((targets[i] >= joint.lower && targets[i] <= joint.upper));
    }
  }
}

TEST_CASE("one controller serves several hands, a copy controls like its original, float like double") {
  const HandProfile profile = limited_profile();
  const SphereControllerOptions options{.time_constant = 0.05};
  SphereController<double> controller(profile, options), copy = controller;
  SphereController<float> single(profile, options);
  std::mt19937_64 random(6);
  std::vector<double> alone = reference_posture(profile), first = alone, second(5);
  std::vector<float> narrow(alone.begin(), alone.end());
  REQUIRE(controller.reset(second, second) == Status::ok);
  for (int n = 0; n < 200; ++n) {
    const std::vector<double> action = test::random_action(random, 0.5, 0.8);
    const std::vector<float> action_narrow(action.begin(), action.end());
    REQUIRE(update(copy, action, 0.01, alone) == Status::ok);
    REQUIRE(update(controller, action, 0.01, first) == Status::ok);
    REQUIRE(update(controller, test::random_action(random, 0.5, 0.8), 0.02, second) == Status::ok);
    REQUIRE(single.update({.values = action_narrow, .driving_vectors_phi = {}}, 0.01f, narrow) == Status::ok);
    CHECK(first == alone);
    for (std::size_t i = 0; i < alone.size(); ++i) CHECK(std::abs(double(narrow[i]) - alone[i]) < 1e-4);
  }
}

TEST_CASE("a solution found elsewhere is approached as an update approaches its own") {
  const HandProfile profile = limited_profile();
  SphereController<double> controller(profile, {.range_scale = 0.8, .time_constant = 0.05});
  std::mt19937_64 random(7);
  std::vector<double> updated = reference_posture(profile), approached = updated;
  for (int n = 0; n < 50; ++n) {
    const std::vector<double> action = test::random_action(random, 0.5, 0.8);
    REQUIRE(update(controller, action, 0.01, updated) == Status::ok);
    REQUIRE(controller.approach(solve(profile, action), 0.01, approached) == Status::ok);
    CHECK(approached == updated);
  }
  std::vector<double> bad(5, 0.0);
  CHECK(controller.approach(bad, 0, approached) == Status::invalid_period);
  CHECK(controller.approach(std::span(bad).first(4), 0.01, approached) == Status::wrong_size);
  bad[3] = kNan;
  CHECK(controller.approach(bad, 0.01, approached) == Status::non_finite_input);
  CHECK(approached == updated);
}

TEST_CASE("options out of their range are refused") {
  const HandProfile profile = limited_profile();
  const auto refuses = [&](const SphereControllerOptions& options) {
    try {
      SphereController<double> controller(profile, options);
    } catch (const Error& error) {
      return error.code() == ErrorCode::invalid_option;
    }
    return false;
  };
  for (double scale : {0.0, -1.0, kNan, kInfinity}) CHECK(refuses({.velocity_scale = scale}));
  for (double scale : {0.0, -1.0, 1.5, kNan}) CHECK(refuses({.range_scale = scale}));
  for (double seconds : {-1.0, kNan, kInfinity}) CHECK(refuses({.time_constant = seconds}));
}
