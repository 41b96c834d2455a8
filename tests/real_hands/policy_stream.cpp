// A policy's raw output, good and bad, through controller and solver: every joint value finite and within limits, every
// residual that is stated confirmed by forward kinematics, what is not finite refused and without effect.
// UHAS_RANDOM_ACTIONS sets the number of actions; the long form is five million.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "support/environment.hpp"
#include "support/random_policy.hpp"
#include "support/real_profile.hpp"
#include "support/stated_residual.hpp"
#include "uhas/runtime/batch_solver.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr std::uint64_t kSeed = 41;
constexpr std::uint64_t kEpisodeLength = 250;

/// The ways of solving: those that cost a few microseconds, and those by the interpolated field or by contact, which
/// cost ten times as much. `contact` makes one pass, however many are asked for.
std::vector<SolveOptions> fast_options() {
  std::vector<SolveOptions> all;
  for (CascadeClosing closing : {CascadeClosing::fade, CascadeClosing::hard})
    for (int passes : {1, 3}) all.push_back({CascadeRule::correspondence, closing, FieldReading::finger, passes});
  return all;
}
std::vector<SolveOptions> slow_options() {
  std::vector<SolveOptions> all{kUhasSim};
  for (CascadeClosing closing : {CascadeClosing::fade, CascadeClosing::hard}) {
    for (int passes : {1, 3}) all.push_back({CascadeRule::correspondence, closing, FieldReading::field, passes});
    for (FieldReading field : {FieldReading::finger, FieldReading::field})
      all.push_back({CascadeRule::contact, closing, field});
  }
  return all;
}

/// What was tried and the worst that was seen, over the run.
struct Findings {
  std::uint64_t actions = 0, refused = 0, batch_rows = 0, at_edge = 0, without_points = 0;
  std::uint64_t faults = 0;
  double nearest_limit = std::numeric_limits<double>::infinity();  // of an independent joint, rad or m; < 0: past it
  double follower_beyond = 0;                                      // of a follower past its own limits, rad or m
  double disagreement[2]{};  // radii, of residuals stated and found: in float, in double
  double allowed_share = 0;  // of that in what rounding explains
  std::vector<float> residuals;

  template <class... Words>
  void require(bool holds, const Words&... what) {
    if (holds || ++faults > 10) return;
    std::cout << "action " << actions << " of seed " << kSeed << ": ";
    (std::cout << ... << what) << '\n';
  }
};

template <class Real>
void check_posture(const HandProfile& profile, std::span<const Real> q, const char* whose, Findings& findings) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = profile.tree.joints[i];
    const Real inside = std::min(q[i] - static_cast<Real>(joint.lower), static_cast<Real>(joint.upper) - q[i]);
    if (joint.mimic_master < 0) {
      findings.require(inside >= 0, whose, ": joint ", joint.name, " = ", q[i]);
      findings.nearest_limit = std::min(findings.nearest_limit, double(inside));
      continue;
    }
    // limits of a master are narrowed so that its followers keep theirs, up to rounding of one product
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon();
    const Real led =
        static_cast<Real>(joint.mimic_multiplier) * q[joint.mimic_master] + static_cast<Real>(joint.mimic_offset);
    findings.require(std::abs(q[i] - led) <= rounding * std::max(Real(1), std::abs(led)), whose, ": joint ", joint.name,
                     " = ", q[i], ", off its master");
    findings.require(inside >= -std::max(rounding, Real(1e-9)), whose, ": follower ", joint.name, " = ", q[i]);
    findings.follower_beyond = std::max(findings.follower_beyond, -double(inside));
  }
}

template <class Real>
std::vector<double> widened(std::span<const Real> numbers) {
  return {numbers.begin(), numbers.end()};
}

/// The residual that a solve stated against the one that forward kinematics finds. Their distance is bounded by what
/// rounding explains: a few hundred sums of numbers of the size of a target, and displacements that are off by as much.
template <class Real>
void check_residual(ResidualCheck& check, const Action<Real>& action, std::span<const Real> q, double stated,
                    Findings& findings) {
  const std::vector<double> values = widened(action.values), phi = widened(action.driving_vectors_phi),
                            offsets = widened(action.azimuth_offsets), bounds = widened(action.radial_bounds);
  const double epsilon = 16 * double(std::numeric_limits<Real>::epsilon());
  const StatedResidual found = check.of({values, phi, action.normalized, offsets, bounds}, widened(q), epsilon);
  if (std::isnan(stated)) {
    findings.require(found.may_be_nothing, "no residual is stated, ", found.low, " found");
    ++findings.without_points;
    return;
  }
  const double apart = std::max({found.low - stated, stated - found.high, 0.0});
  findings.require(apart <= found.rounding, "residual ", stated, " stated, ", found.low, " to ", found.high, " found");
  double& worst = findings.disagreement[sizeof(Real) == sizeof(double)];
  worst = std::max(worst, apart);
  findings.allowed_share = std::max(findings.allowed_share, apart / found.rounding);
  findings.at_edge += found.low != found.high;
  findings.residuals.push_back(static_cast<float>(stated));
}

/// Rows of a batch are the same bytes on one thread and on three, in any order, and refused rows stay untouched.
template <class Real>
void check_batch(const HandProfile& profile, const PolicySetting<Real>& setting,
                 const std::vector<std::vector<Real>>& actions, Findings& findings) {
  const std::size_t rows = actions.size(), joints = profile.tree.joints.size();
  constexpr Real untouched = 77;
  const auto solve = [&](int threads, bool reversed, std::vector<Status>& statuses) {
    std::vector<Real> values, q(rows * joints, untouched);
    for (std::size_t n = 0; n < rows; ++n) {
      const std::vector<Real>& row = actions[reversed ? rows - 1 - n : n];
      values.insert(values.end(), row.begin(), row.end());
    }
    BatchSolver<Real> solver(profile, setting.controller.solve, {.threads = threads});
    solver.solve({.count = rows,
                  .values = values,
                  .driving_vectors = setting.vectors,
                  .driving_vectors_phi = setting.phi,
                  .normalized = setting.normalized,
                  .azimuth_offsets = setting.offsets,
                  .radial_bounds = setting.bounds},
                 q, statuses);
    return q;
  };
  std::vector<Status> statuses(rows), statuses_reversed(rows);
  const std::vector<Real> q = solve(1, false, statuses), q_reversed = solve(3, true, statuses_reversed);
  for (std::size_t n = 0; n < rows; ++n) {
    const std::size_t other = rows - 1 - n;
    const std::span<const Real> row = std::span(q).subspan(n * joints, joints);
    findings.require(
        std::equal(row.begin(), row.end(), q_reversed.begin() + static_cast<std::ptrdiff_t>(other * joints)) &&
            statuses[n] == statuses_reversed[other],
        "a row of a batch depends on threads or order");
    const bool finite = std::all_of(actions[n].begin(), actions[n].end(), [](Real x) { return std::isfinite(x); });
    findings.require(statuses[n] == (finite ? Status::ok : Status::non_finite_input), "status of a row of a batch");
    if (finite)
      check_posture(profile, row, "batch", findings);
    else
      findings.require(std::all_of(row.begin(), row.end(), [](Real x) { return x == untouched; }),
                       "a refused row is written");
  }
  findings.batch_rows += rows;
}

/// What an episode is besides its policy: whether the controller solves by itself or is given the solution, and whether
/// a batch solves the actions once more.
struct Episode {
  SolveOptions options;
  bool updates = false, with_batch = false;
};

template <class Real>
void run_episode(const HandProfile& profile, const Episode& episode, Random& random, Findings& findings) {
  const auto& [options, updates, with_batch] = episode;
  const PolicySetting<Real> setting(random, options);
  SphereController<Real> controller(profile, setting.controller);
  CascadeSolver<Real> solver(profile, options);
  ResidualCheck residual(profile, options);
  RandomPolicy policy(kSlotCount * (1 + setting.vectors));
  const std::size_t joints = profile.tree.joints.size();
  std::vector<Real> values, solved_values, targets(joints), q(joints), before(joints), again(joints);
  std::vector<std::vector<Real>> actions;

  for (Real& x : targets) x = static_cast<Real>(uniform(random, -4, 4));
  findings.require(controller.reset(targets, targets) == Status::ok, "a reset is refused");
  check_posture<Real>(profile, targets, "reset", findings);
  for (std::uint64_t n = 0; n < kEpisodeLength; ++n, ++findings.actions) {
    policy.act(random, values);
    const bool bad = happens(random, 0.01);
    if (bad) poison(random, values);
    if (with_batch) actions.push_back(values);
    const Action<Real> action = setting.action(values);
    const Real dt = static_cast<Real>(std::pow(10, uniform(random, -4, 0)));
    SolveReport report;
    before = targets, again = q;
    const Status solved = solver.solve(action, q, report);
    const Status updated =
        updates || bad ? controller.update(action, dt, targets) : controller.approach(q, dt, targets);
    if (bad) {
      ++findings.refused;
      findings.require(updated == Status::non_finite_input && solved == Status::non_finite_input, "is not refused");
      findings.require(targets == before && q == again, "is refused and changes the output");
      if (solved_values.empty()) continue;
      findings.require(solver.solve(setting.action(solved_values), again) == Status::ok && again == q,
                       "is refused and changes the next solution");
      continue;
    }
    findings.require(updated == Status::ok && solved == Status::ok, "is refused");
    check_posture<Real>(profile, targets, "controller", findings);
    check_posture<Real>(profile, q, "solver", findings);
    check_residual<Real>(residual, action, q, report.residual_rms, findings);
    solved_values = values;
  }
  if (with_batch) check_batch(profile, setting, actions, findings);
}

void print(const HandProfile& profile, Findings& findings) {
  std::vector<float>& residuals = findings.residuals;
  const auto quantile = [&](double share) {
    const auto at = residuals.begin() + static_cast<std::ptrdiff_t>(share * double(residuals.size() - 1));
    std::nth_element(residuals.begin(), at, residuals.end());
    return *at;
  };
  std::cout << profile.hand << ", seed " << kSeed << ": " << findings.actions << " actions, " << findings.refused
            << " not finite and refused; " << findings.batch_rows << " of them in batches, too\n"
            << "  nearest to a limit " << findings.nearest_limit << "; followers past theirs by "
            << findings.follower_beyond << " at most\n  residuals: median " << quantile(0.5) << ", p99.9 "
            << quantile(0.999) << ", largest " << quantile(1) << " radii; stated and found apart by "
            << findings.disagreement[1] << " (double), " << findings.disagreement[0] << " (float) at most, "
            << 100 * findings.allowed_share << " % of what rounding explains\n  without points "
            << findings.without_points << ", at an edge " << findings.at_edge << "; faults " << findings.faults << '\n';
}

}  // namespace

TEST_CASE("whatever a policy puts out, joints stay within limits and residuals are true") {
  const HandProfile& profile = real_profile();
  const std::uint64_t actions = number_from_environment("UHAS_RANDOM_ACTIONS", 30'000);
  const std::vector<SolveOptions> fast = fast_options(), slow = slow_options();
  Random random(kSeed);
  Findings findings;
  // four episodes of five by a fast way; in one of four the controller solves by itself, in another a batch comes after
  for (std::uint64_t n = 0; findings.actions < actions; ++n) {
    const std::vector<SolveOptions> options = n % 5 == 4 ? slow : fast;
    const std::uint64_t round = n / 5;
    const Episode episode{options[(n % 5 + round) % options.size()], round % 4 == 0, round % 4 == 1};
    if (choose(random, 0, 1) == 0)
      run_episode<float>(profile, episode, random, findings);
    else
      run_episode<double>(profile, episode, random, findings);
  }
  print(profile, findings);
  CHECK(findings.faults == 0);
  CHECK(findings.at_edge <= findings.actions / 50);  // hardly any residual is in doubt
}
