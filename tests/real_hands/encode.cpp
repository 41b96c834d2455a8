// Encode and retarget on every hand (docs/method.md#encode-and-retarget): what a solve gave comes back, and how far
// other postures stay away.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "support/environment.hpp"
#include "support/random_action.hpp"
#include "support/real_profile.hpp"
#include "uhas/runtime/encoding/encoder_model.hpp"
#include "uhas/runtime/retarget.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kTolerance = 0.01;  // rad
constexpr double kReach = 0.6;       // |d r| of the random actions, radii

std::size_t action_count() { return number_from_environment("UHAS_RANDOM_ACTIONS", 3000); }

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())))];
}

std::string summary(const std::vector<double>& errors) {
  const auto text = [&](double share) { return std::to_string(quantile(errors, share)); };
  return std::to_string(errors.size()) + " postures, median " + text(0.5) + ", p99 " + text(0.99) + ", worst " +
         text(1);
}

/// A random action whose d theta lies within every finger's bounds.
std::vector<double> action_within_bounds(const HandProfile& profile, std::mt19937_64& random, int vectors) {
  std::vector<double> action = random_action(random, 1, kReach, vectors);
  for (const ProfileFinger& finger : profile.fingers) {
    const LateralTable* table = finger.lateral_table < 0 ? nullptr : &profile.lateral_tables[finger.lateral_table];
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (finger.slots[slot] && table)
        action[slot] *= action[slot] < 0 ? -table->delta_theta_lower : table->delta_theta_upper;
  }
  return action;
}

/// Solves actions and says which fingers an action has clamped: wider limits would give them another posture, or a
/// joint has closed.
struct Source {
  Source(const HandProfile& hand, const SolveOptions& options)
      : profile(hand),
        whole_hand(options.field == FieldReading::field),
        solver(hand, options),
        wider(with_wider_limits(hand), options),
        q(solver.joint_count()),
        q_wider(q.size()),
        closed(q.size()) {}

  void solve(const std::vector<double>& action) {
    SolveReport report{.residual_rms = 0, .at_limit = {}, .closed = closed};
    REQUIRE(solver.solve({.values = action, .driving_vectors_phi = {}}, q, report) == Status::ok);
    REQUIRE(wider.solve({.values = action, .driving_vectors_phi = {}}, q_wider) == Status::ok);
  }

  /// In the reading `field` each point follows two planes: one finger is as free as the whole hand.
  bool clamps(const ProfileFinger& finger) const {
    return whole_hand ? std::ranges::any_of(profile.fingers, [&](const ProfileFinger& f) { return clamps_joint_of(f); })
                      : clamps_joint_of(finger);
  }

  double error(const ProfileFinger& finger, const std::vector<double>& again) const {
    double largest = 0;
    for (int joint : finger.joints) largest = std::max(largest, std::abs(again[joint] - q[joint]));
    return largest;
  }

  const HandProfile& profile;
  bool whole_hand;
  CascadeSolver<double> solver, wider;
  std::vector<double> q, q_wider;
  std::vector<std::uint8_t> closed;

 private:
  bool clamps_joint_of(const ProfileFinger& finger) const {
    return std::ranges::any_of(
        finger.joints, [&](int joint) { return closed[joint] != 0 || std::abs(q[joint] - q_wider[joint]) > 1e-9; });
  }
};

/// Prints the errors of solve(encode(solve(a))) over random actions, apart for each finger's free postures and for
/// those that clamp a joint. Returns how many of the free ones exceed the tolerance.
template <class Real>
std::size_t exceeding_round_trips(const SolveOptions& options, int vectors, std::size_t actions,
                                  const std::string& title) {
  const HandProfile& profile = real_profile();
  Source source(profile, options);
  Encoder<Real> encoder(profile, options, vectors);
  std::vector<std::vector<double>> free(profile.fingers.size()), clamped(profile.fingers.size());
  std::vector<double> again(source.q.size());
  std::vector<Real> action(encoder.action_size());
  std::mt19937_64 random(17);
  for (std::size_t n = 0; n < actions; ++n) {
    source.solve(action_within_bounds(profile, random, vectors));
    EncodeReport report;
    const std::vector<Real> q(source.q.begin(), source.q.end());
    REQUIRE(encoder.encode(q, action, report) == Status::ok);
    const std::vector<double> encoded(action.begin(), action.end());
    REQUIRE(source.solver.solve({.values = encoded, .driving_vectors_phi = {}}, again) == Status::ok);
    for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
      const ProfileFinger& finger = profile.fingers[f];
      (source.clamps(finger) ? clamped : free)[f].push_back(source.error(finger, again));
    }
  }
  std::size_t all_exceeding = 0;
  for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
    const auto exceeding = std::ranges::count_if(free[f], [](double e) { return e > kTolerance; });
    std::cout << profile.hand << ' ' << profile.fingers[f].name << ", " << title << ": " << summary(free[f]) << ", "
              << exceeding << " above " << kTolerance << "; joints clamped: " << summary(clamped[f]) << '\n';
    all_exceeding += exceeding;
  }
  return all_exceeding;
}

}  // namespace

TEST_CASE("what a solve gave without clamping a joint is encoded to an action that gives it again") {
  const std::size_t many = action_count(), some = many / 5;
  CHECK(exceeding_round_trips<double>({}, 2, many, "V = 2") == 0);
  // one posture of 249 on the pinky of the Shadow hand in hands/, whose five joints V = 4 moves: 0.02 rad
  for (int vectors : {1, 3, 4})
    CHECK(exceeding_round_trips<double>({}, vectors, some, "V = " + std::to_string(vectors)) <= some / 300);
  CHECK(exceeding_round_trips<double>({.passes = 3}, 2, some, "three passes") == 0);
  CHECK(exceeding_round_trips<double>({.closing = CascadeClosing::hard}, 2, some, "hard closing") == 0);
  CHECK(exceeding_round_trips<double>({.field = FieldReading::field}, 2, some, "reading `field`") == 0);
  CHECK(exceeding_round_trips<float>({}, 2, some, "float") == 0);
  // where a joint meets the sphere jumps from one part of the deformed profile to another: the descent may stop there
  exceeding_round_trips<double>({.rule = CascadeRule::contact}, 2, some, "rule `contact`, not checked");
}

TEST_CASE("any other posture is told its distance from the action manifold") {
  const HandProfile& profile = real_profile();
  CascadeSolver<double> solver(profile);
  for (int vectors : {2, 4}) {
    Encoder<double> encoder(profile, {}, vectors);
    std::vector<double> q(solver.joint_count()), again(q.size()), action(encoder.action_size()), largest, rms;
    std::mt19937_64 random(19);
    for (std::size_t n = 0; n < action_count() / 5; ++n) {
      for (std::size_t i = 0; i < q.size(); ++i) {
        const Joint& joint = profile.tree.joints[i];
        q[i] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
      }
      EncodeReport report;
      REQUIRE(encoder.encode(q, action, report) == Status::ok);
      REQUIRE(solver.solve({.values = action, .driving_vectors_phi = {}}, again) == Status::ok);
      double found = 0;
      for (std::size_t i = 0; i < q.size(); ++i)
        if (profile.tree.joints[i].mimic_master < 0) found = std::max(found, std::abs(again[i] - q[i]));
      CHECK(report.residual_max == doctest::Approx(found));
      largest.push_back(report.residual_max);
      rms.push_back(report.residual_rms);
    }
    std::cout << profile.hand << ", joint values drawn uniformly, V = " << vectors << ": largest " << summary(largest)
              << "; rms " << summary(rms) << '\n';
  }
}

TEST_CASE("a hand retargeted to itself keeps the postures that a solve gave") {
  const HandProfile& profile = real_profile();
  Source source(profile, {});
  Retargeter<double> retargeter(profile, profile);
  std::mt19937_64 random(23);
  std::vector<double> again(source.q.size());
  int left_out = 0;
  for (std::size_t n = 0; n < action_count() / 5; ++n) {
    source.solve(action_within_bounds(profile, random, 2));
    EncodeReport report;
    REQUIRE(retargeter.retarget(source.q, again, report) == Status::ok);
    for (const ProfileFinger& finger : profile.fingers) {
      CAPTURE(finger.name);
      if (source.clamps(finger))
        ++left_out;
      else
        CHECK(source.error(finger, again) <= kTolerance);
    }
  }
  std::cout << profile.hand << ", retargeted to itself: " << left_out << " fingers with a clamped joint left out\n";
}
