// What must hold of the solver on every hand (docs/method.md#the-cascade).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <set>
#include <string>

#include "support/random_action.hpp"
#include "support/real_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kTwoVectors = 2;

std::vector<double> solve(CascadeSolver<double>& solver, const std::vector<double>& action) {
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve({.values = action}, q) == Status::ok);
  return q;
}

std::vector<SolveOptions> all_options() {
  std::vector<SolveOptions> all;
  for (CascadeRule rule : {CascadeRule::correspondence, CascadeRule::contact})
    for (CascadeClosing closing : {CascadeClosing::fade, CascadeClosing::hard})
      for (FieldReading field : {FieldReading::finger, FieldReading::field})
        for (int passes : {1, 3}) all.push_back({rule, closing, field, passes});
  return all;
}

/// All radial inputs of the slots that `finger` owns.
void set_radial(const ProfileFinger& finger, double delta_r, std::vector<double>& action) {
  for (int slot = 0; slot < kSlotCount; ++slot)
    if (finger.slots[slot])
      for (int j = 0; j < kTwoVectors; ++j)
        action[static_cast<std::size_t>(kSlotCount + kTwoVectors * slot + j)] = delta_r;
}

bool moves(const HandProfile& profile, const ProfileFinger& finger, int joint) {
  (void)profile;
  return std::find(finger.joints.begin(), finger.joints.end(), joint) != finger.joints.end();
}

}  // namespace

TEST_CASE("the zero action returns q_sphere") {
  const HandProfile& profile = real_profile();
  for (const SolveOptions& options : all_options()) {
    CAPTURE(static_cast<int>(options.rule));
    CAPTURE(static_cast<int>(options.field));
    CAPTURE(static_cast<int>(options.closing));
    CAPTURE(options.passes);
    CascadeSolver<double> solver(profile, options);
    for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) {
      const std::vector<double> q = solve(solver, std::vector<double>(kSlotCount * (1 + vectors), 0.0));
      for (std::size_t i = 0; i < q.size(); ++i) {
        CAPTURE(profile.tree.joints[i].name);
        CHECK(std::abs(q[i] - profile.joint_traits[i].q_sphere) <= 1e-9);
      }
    }
  }
}

TEST_CASE("every finite action gives finite joint values within limits") {
  const HandProfile& profile = real_profile();
  const char* count = std::getenv("UHAS_RANDOM_ACTIONS");
  const int actions = count ? std::atoi(count) : 100'000;
  for (CascadeRule rule : {CascadeRule::correspondence, CascadeRule::contact}) {
    std::mt19937_64 random(7);
    std::vector<CascadeSolver<double>> solvers;
    for (const SolveOptions& options : all_options())
      if (options.rule == rule) solvers.emplace_back(profile, options);
    std::vector<double> q(profile.tree.joints.size());
    int bad = 0;
    for (int n = 0; n < actions && bad == 0; ++n) {
      const int vectors = 1 + n % kMaxDrivingVectors;
      const double scale = n % 10 == 0 ? 1e300 : 3.0;  // now and then far beyond every bound
      const std::vector<double> action = random_action(random, scale, scale, vectors);
      const Status status = solvers[n % solvers.size()].solve({.values = action}, q);
      bad += status != Status::ok;
      for (std::size_t i = 0; i < q.size(); ++i) {
        const Joint& joint = profile.tree.joints[i];
        const double slack = joint.mimic_master < 0 ? 0 : 1e-9;
        if (!(q[i] >= joint.lower - slack && q[i] <= joint.upper + slack)) {
          ++bad;
          std::cout << "action " << n << " of seed 7: joint " << joint.name << " = " << q[i] << '\n';
        }
      }
    }
    CHECK(bad == 0);
  }
}

TEST_CASE("input that is not finite is refused and the output untouched") {
  CascadeSolver<double> solver(real_profile());
  for (double poison : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t at = 0; at < 15; ++at) {
      std::vector<double> action(15, 0.1), q(solver.joint_count(), 42.0);
      action[at] = poison;
      CHECK(solver.solve({.values = action}, q) == Status::non_finite_input);
      CHECK(std::all_of(q.begin(), q.end(), [](double value) { return value == 42.0; }));
    }
  }
}

TEST_CASE("contraction closes a finger without a jump") {
  const HandProfile& profile = real_profile();
  CascadeSolver<double> solver(profile);
  std::set<std::string> listed;
  for (const ProfileFinger& finger : profile.fingers) {
    const bool at_limit = std::any_of(finger.joints.begin(), finger.joints.end(), [&](int i) {
      const Joint& joint = profile.tree.joints[i];
      const double q = profile.joint_traits[i].q_sphere;
      return joint.mimic_master < 0 && profile.joint_traits[i].joint_class == JointClass::encompassing &&
             (q - joint.lower < 1e-6 || joint.upper - q < 1e-6);
    });
    std::vector<double> action(15, 0.0), before;
    double largest = 0, where = 0;
    std::string who;
    for (double delta_r = 0.8; delta_r >= -2.0; delta_r -= 0.03) {
      set_radial(finger, delta_r, action);
      const std::vector<double> q = solve(solver, action);
      for (int i : finger.joints)
        if (!before.empty() && std::abs(q[i] - before[i]) > largest)
          largest = std::abs(q[i] - before[i]), where = delta_r, who = profile.tree.joints[i].name;
      before = q;
    }
    set_radial(finger, -2.0, action);
    const std::vector<double> closed = solve(solver, action);
    for (int i : finger.joints) {
      if (profile.joint_traits[i].joint_class != JointClass::encompassing || profile.tree.joints[i].mimic_master >= 0)
        continue;
      CAPTURE(profile.tree.joints[i].name);
      CHECK(std::abs(closed[i] - profile.joint_traits[i].q_closed) <= 1e-9);
    }
    CAPTURE(finger.name);
    CAPTURE(who);
    CAPTURE(where);
    if (at_limit)
      std::cout << "LISTED: " << profile.hand << ' ' << finger.name
                << ": q_sphere has a joint at a limit; largest step " << largest << " rad of " << who << " at delta r "
                << where << '\n';
    else
      CHECK(largest <= 0.35);
  }
}

TEST_CASE("a spread moves one finger only, and its lateral joint most") {
  const HandProfile& profile = real_profile();
  CascadeSolver<double> solver(profile);
  const std::vector<double> rest = solve(solver, std::vector<double>(15, 0.0));
  for (const ProfileFinger& finger : profile.fingers) {
    std::vector<double> action(15, 0.0);
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (finger.slots[slot]) action[slot] = 0.15;
    const std::vector<double> q = solve(solver, action);
    double most = -1;
    int moved_most = -1;
    for (int i = 0; i < static_cast<int>(q.size()); ++i) {
      CAPTURE(finger.name);
      CAPTURE(profile.tree.joints[i].name);
      const double motion = std::abs(q[i] - rest[i]);
      if (!moves(profile, finger, i)) CHECK(motion == 0.0);
      if (motion > most) most = motion, moved_most = i;
    }
    if (finger.lateral_table < 0) continue;
    CAPTURE(finger.name);
    CHECK(moved_most == profile.lateral_tables[finger.lateral_table].joint);
  }
}

TEST_CASE("float follows double") {
  const HandProfile& profile = real_profile();
  CascadeSolver<double> solver(profile);
  CascadeSolver<float> single(profile);
  std::mt19937_64 random(11);
  std::vector<double> errors;
  std::vector<float> q_float(single.joint_count());
  for (int n = 0; n < 2000; ++n) {
    std::vector<double> action = random_action(random, 0.5, 1.0);
    std::vector<float> action_float(action.begin(), action.end());
    action.assign(action_float.begin(), action_float.end());
    const std::vector<double> q = solve(solver, action);
    REQUIRE(single.solve({.values = action_float}, q_float) == Status::ok);
    for (std::size_t i = 0; i < q.size(); ++i) errors.push_back(std::abs(q[i] - double(q_float[i])));
  }
  std::sort(errors.begin(), errors.end());
  CHECK(errors[errors.size() * 999 / 1000] <= 1e-4);
}
