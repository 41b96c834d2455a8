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
#include "uhas/runtime/retarget.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kTolerance = 0.01;  // rad

std::size_t action_count() { return number_from_environment("UHAS_RANDOM_ACTIONS", 3000); }

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())))];
}

std::string summary(const std::vector<double>& errors) {
  const auto text = [&](double share) { return std::to_string(quantile(errors, share)); };
  return std::to_string(errors.size()) + " postures, median " + text(0.5) + ", p99 " + text(0.99) + ", worst " +
         text(1);
}

/// Anywhere within bounds.
std::vector<double> any_action(std::mt19937_64& random, int vectors) {
  return random_action(random, 1.5, kRadialBound, vectors);
}

double largest_error(const std::vector<double>& again, const std::vector<double>& q) {
  double largest = 0;
  for (std::size_t i = 0; i < q.size(); ++i) largest = std::max(largest, std::abs(again[i] - q[i]));
  return largest;
}

/// Prints the errors of solve(encode(solve(a))) over random actions, and the fingers whose report exceeds the tolerance.
/// Returns the share of postures that come back, all joints within the tolerance.
template <class Real>
double share_given_back(const SolveOptions& options, int vectors, std::size_t actions, const std::string& title) {
  const HandProfile& profile = real_profile();
  CascadeSolver<double> solver(profile, options);
  Encoder<Real> encoder(profile, options, vectors);
  std::vector<double> q(solver.joint_count()), again(q.size()), errors;
  std::vector<Real> action(encoder.action_size());
  std::vector<int> missed(profile.fingers.size());
  std::mt19937_64 random(17);
  for (std::size_t n = 0; n < actions; ++n) {
    REQUIRE(solver.solve({.values = any_action(random, vectors)}, q) == Status::ok);
    EncodeReport report;
    REQUIRE(encoder.encode(std::vector<Real>(q.begin(), q.end()), action, report) == Status::ok);
    REQUIRE(solver.solve({.values = std::vector<double>(action.begin(), action.end())}, again) == Status::ok);
    errors.push_back(largest_error(again, q));
    for (std::size_t f = 0; f < missed.size(); ++f) missed[f] += report.fingers[f].residual > kTolerance;
  }
  std::cout << profile.hand << ", " << title << ": " << summary(errors) << "; above " << kTolerance << ':';
  for (std::size_t f = 0; f < missed.size(); ++f) std::cout << ' ' << profile.fingers[f].name << ' ' << missed[f];
  std::cout << '\n';
  return double(std::ranges::count_if(errors, [](double e) { return e <= kTolerance; })) / double(actions);
}

}  // namespace

TEST_CASE("what a solve gave is encoded to an action that gives it again, joints at limits or not") {
  const std::size_t many = action_count(), some = many / 5;
  CHECK(share_given_back<double>({}, 2, many, "V = 2") >= 0.99);
  for (int vectors : {1, 3, 4})
    CHECK(share_given_back<double>({}, vectors, some, "V = " + std::to_string(vectors)) >= 0.98);
  CHECK(share_given_back<float>({}, 2, some, "float") >= 0.99);
  CHECK(share_given_back<double>({.passes = 3}, 2, some, "three passes") >= 0.98);
  // fingers of a hand are sought together: twelve starts have to be right for all of them at once
  CHECK(share_given_back<double>({.field = FieldReading::field}, 2, some / 5, "reading `field`") >= 0.9);
  // points are dropped one by one and a contact jumps along the profile: a descent does not see such steps
  CHECK(share_given_back<double>({.closing = CascadeClosing::hard}, 2, some, "hard closing") >= 0.8);
  CHECK(share_given_back<double>({.rule = CascadeRule::contact}, 2, some / 5, "rule `contact`") >= 0.9);
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
      for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
        const FingerResidual& worst = report.fingers[f];
        CHECK(worst.residual == doctest::Approx(std::abs(again[worst.joint] - q[worst.joint])));
        for (int joint : profile.fingers[f].joints)
          if (profile.tree.joints[joint].mimic_master < 0)
            CHECK(std::abs(again[joint] - q[joint]) <= doctest::Approx(worst.residual));
      }
      largest.push_back(report.residual_max);
      rms.push_back(report.residual_rms);
    }
    std::cout << profile.hand << ", joint values drawn uniformly, V = " << vectors << ": largest " << summary(largest)
              << "; rms " << summary(rms) << '\n';
  }
}

TEST_CASE("a hand retargeted to itself keeps the postures that a solve gave") {
  const HandProfile& profile = real_profile();
  CascadeSolver<double> solver(profile);
  Retargeter<double> retargeter(profile, profile);
  std::mt19937_64 random(23);
  std::vector<double> q(solver.joint_count()), again(q.size());
  const std::size_t count = action_count() / 5;
  std::size_t kept = 0;
  for (std::size_t n = 0; n < count; ++n) {
    REQUIRE(solver.solve({.values = any_action(random, 2)}, q) == Status::ok);
    EncodeReport report;
    REQUIRE(retargeter.retarget(q, again, report) == Status::ok);
    kept += largest_error(again, q) <= kTolerance;
  }
  CHECK(double(kept) >= 0.99 * double(count));
}
