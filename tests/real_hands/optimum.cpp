// The cascade against a numerical optimum of J = sum w s |p - t|^2 a finger (docs/method.md#how-near-to-the-optimum):
// NLopt, several starts, same limits. Targets and shares are written here a second time, from that page alone.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlopt.hpp>
#include <numbers>
#include <numeric>

#include "support/random_action.hpp"
#include "support/real_profile.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// Fingers of one connected part of the hand and the unknowns that move them: a finger by itself unless
/// joints are shared.
struct Problem {
  std::vector<int> fingers;
  std::vector<int> unknowns;  // independent encompassing joints
};

struct Pair {
  int joint;
  Vector3d p_joint, t;
  double w;
};

std::vector<Problem> problems_of(const HandProfile& profile) {
  std::vector<Problem> problems;
  for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f) {
    Problem problem{.fingers = {f}, .unknowns = {}};
    for (int joint : profile.fingers[f].joints) {
      const int master = profile.tree.joints[joint].mimic_master;
      const int unknown = master < 0 ? joint : master;
      if (profile.joint_traits[unknown].joint_class == JointClass::encompassing &&
          std::find(problem.unknowns.begin(), problem.unknowns.end(), unknown) == problem.unknowns.end())
        problem.unknowns.push_back(unknown);
    }
    if (!problem.unknowns.empty()) problems.push_back(problem);
  }
  return problems;
}

double radial(const std::vector<double>& delta_r, double phi) {
  // V = 2: 0 at the pole, delta_r[0] at 60 degrees, delta_r[1] from 120 degrees on
  if (phi < kPi / 3) return delta_r[0] * phi / (kPi / 3);
  if (phi < 2 * kPi / 3) return delta_r[0] + (delta_r[1] - delta_r[0]) * (phi - kPi / 3) / (kPi / 3);
  return delta_r[1];
}

std::vector<Pair> pairs_of(const HandProfile& profile, const Problem& problem, const std::vector<double>& action) {
  std::vector<Pair> pairs;
  const ProfileFinger& finger = profile.fingers[problem.fingers[0]];
  double delta_theta = 0, slots = 0;
  std::vector<double> delta_r(2, 0.0);
  for (int slot = 0; slot < kSlotCount; ++slot) {
    if (!finger.slots[slot]) continue;
    double lower = 0, upper = 0;
    if (finger.lateral_table >= 0) {
      lower = profile.lateral_tables[finger.lateral_table].delta_theta_lower;
      upper = profile.lateral_tables[finger.lateral_table].delta_theta_upper;
    }
    delta_theta += std::clamp(action[slot], lower, upper);
    for (int j = 0; j < 2; ++j) delta_r[j] += action[5 + 2 * slot + j];
    slots += 1;
  }
  delta_theta /= slots;
  for (double& d : delta_r) d /= slots;

  for (const Correspondence& c : profile.correspondences) {
    const ProfileLink& link = profile.links[c.link];
    if (c.weight <= 0 || std::find(finger.joints.begin(), finger.joints.end(), link.joint) == finger.joints.end())
      continue;
    const double d = radial(delta_r, c.phi);
    const double u = std::clamp((1 + (c.phi < kPi / 3 ? delta_r[0] : d)) / 0.5, 0.0, 1.0);
    const double share = u * u * (3 - 2 * u);
    const double azimuth = (profile.mirrored ? -1 : 1) * (c.theta + delta_theta);
    const Vector3d t = from_spherical<double>({azimuth, c.phi, std::max(c.rho + d, 0.0)});
    pairs.push_back(
        {link.joint, link.T_joint_link * c.p_link, profile.T_palm_sphere * (profile.radius * t), c.weight * share});
  }
  return pairs;
}

double cost(const HandProfile& profile, const std::vector<Pair>& pairs, std::vector<double> q) {
  apply_mimics(profile.tree, q);
  static thread_local std::vector<RigidTransformd> T;
  T.resize(q.size());
  forward_kinematics(profile.tree, q, T);
  double sum = 0;
  for (const Pair& pair : pairs) {
    const Vector3d e = (T[pair.joint] * pair.p_joint - pair.t) / profile.radius;
    sum += pair.w * dot(e, e);
  }
  return sum;
}

struct Objective {
  const HandProfile& profile;
  const Problem& problem;
  const std::vector<Pair>& pairs;
  std::vector<double> q;
};

double evaluate(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  Objective& objective = *static_cast<Objective*>(data);
  std::vector<double> q = objective.q;
  for (std::size_t i = 0; i < x.size(); ++i) q[objective.problem.unknowns[i]] = x[i];
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    constexpr double h = 1e-6;
    std::vector<double> ahead = q, behind = q;
    ahead[objective.problem.unknowns[i]] += h;
    behind[objective.problem.unknowns[i]] -= h;
    gradient[i] =
        (cost(objective.profile, objective.pairs, ahead) - cost(objective.profile, objective.pairs, behind)) / (2 * h);
  }
  return cost(objective.profile, objective.pairs, q);
}

double optimum(const HandProfile& profile, const Problem& problem, const std::vector<Pair>& pairs,
               const std::vector<double>& q) {
  const std::size_t n = problem.unknowns.size();
  std::vector<double> lower(n), upper(n), at(n), open(n), sphere(n), middle(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int joint = problem.unknowns[i];
    lower[i] = profile.tree.joints[joint].lower, upper[i] = profile.tree.joints[joint].upper;
    at[i] = q[joint], open[i] = profile.joint_traits[joint].q_open, sphere[i] = profile.joint_traits[joint].q_sphere;
    middle[i] = (lower[i] + upper[i]) / 2;
  }
  double best = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& start : {at, sphere, open, middle}) {
    Objective objective{profile, problem, pairs, q};
    nlopt::opt opt(nlopt::LD_SLSQP, static_cast<unsigned>(n));
    opt.set_lower_bounds(lower);
    opt.set_upper_bounds(upper);
    opt.set_min_objective(evaluate, &objective);
    opt.set_xtol_rel(1e-9);
    opt.set_maxeval(100);
    std::vector<double> x = start;
    for (std::size_t i = 0; i < n; ++i) x[i] = std::clamp(x[i], lower[i], upper[i]);
    double value = 0;
    try {
      opt.optimize(x, value);
    } catch (const nlopt::roundoff_limited&) {
      std::vector<double> none;
      value = evaluate(x, none, &objective);
    } catch (const std::runtime_error&) {
      continue;
    }
    best = std::min(best, value);
  }
  return best;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? std::nan("")
                        : values[std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())))];
}

}  // namespace

TEST_CASE("the cascade comes near the numerical optimum") {
  const HandProfile& profile = real_profile();
  constexpr int actions = 200;
  const int thumb = thumb_of(profile);
  std::vector<int> pass_counts{1, 3, 10};
  if (const char* more = std::getenv("UHAS_PASSES")) pass_counts = {std::atoi(more)};
  for (int passes : pass_counts) {
    CascadeSolver<double> solver(profile, {.rule = CascadeRule::correspondence,
                                           .closing = CascadeClosing::fade,
                                           .field = FieldReading::finger,
                                           .passes = passes});
    std::vector<double> pooled, thumbs;
    int left_out = 0;
    std::vector<std::vector<double>> by_finger(profile.fingers.size());
    for (bool spread : {false, true}) {
      std::mt19937_64 random(spread ? 2 : 1);
      for (int n = 0; n < actions; ++n) {
        const std::vector<double> action = random_action(random, spread ? 0.5 : 0.0, 0.6);
        std::vector<double> q(solver.joint_count());
        REQUIRE(solver.solve({.values = action}, q) == Status::ok);
        for (const Problem& problem : problems_of(profile)) {
          const std::vector<Pair> pairs = pairs_of(profile, problem, action);
          const double weight =
              std::accumulate(pairs.begin(), pairs.end(), 0.0, [](double a, const Pair& b) { return a + b.w; });
          if (!(weight > 0)) continue;
          const double own = std::sqrt(cost(profile, pairs, q) / weight);
          const double best = std::sqrt(optimum(profile, problem, pairs, q) / weight);
          constexpr double negligible = 0.005;  // radii
          if (best < negligible) {
            ++left_out;
            continue;
          }
          const double ratio = std::max(own / best, 1.0);
          pooled.push_back(ratio);
          by_finger[problem.fingers[0]].push_back(ratio);
          if (problem.fingers[0] == thumb) thumbs.push_back(ratio);
        }
      }
    }
    std::cout << profile.hand << ", passes " << passes << ": median " << quantile(pooled, 0.5) << ", p95 "
              << quantile(pooled, 0.95) << ", worst " << quantile(pooled, 1) << "; thumb median "
              << quantile(thumbs, 0.5) << ", p95 " << quantile(thumbs, 0.95) << "; " << pooled.size() << " ratios, "
              << left_out << " left out\n";
    for (std::size_t f = 0; f < by_finger.size(); ++f)
      std::cout << "    " << profile.fingers[f].name << ": median " << quantile(by_finger[f], 0.5) << ", p95 "
                << quantile(by_finger[f], 0.95) << '\n';
    CHECK(quantile(pooled, 0.5) <= (passes == 1 ? 1.10 : 1.03));
    CHECK(quantile(pooled, 0.95) <= (passes < 10 ? 1.20 : 1.05));
  }
}
