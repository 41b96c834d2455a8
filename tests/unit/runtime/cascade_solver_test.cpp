// The solver on the small profile: coupled joints, a sliding joint, a left hand, shared slots.
#include "uhas/runtime/cascade_solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/arch_profile.hpp"
#include "support/mirrored_profile.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/runtime/batch_solver.hpp"

using namespace uhas;

namespace {

std::vector<double> solve(const HandProfile& profile, const std::vector<double>& action, SolveOptions options = {}) {
  CascadeSolver<double> solver(profile, options);
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve({.values = action}, q) == Status::ok);
  return q;
}

/// Weighted squared distance of the points from targets written down from the formulas of docs/method.md#targets
/// and docs/method.md#closing.
double cost(const HandProfile& profile, const std::vector<double>& q, double delta_theta, double delta_r) {
  std::vector<RigidTransformd> T(q.size());
  forward_kinematics(profile.tree, q, T);
  double sum = 0;
  for (const Correspondence& c : profile.correspondences) {
    const ProfileLink& link = profile.links[c.link];
    if (c.weight <= 0 || link.joint < 0) continue;
    const double anchored = std::min(c.phi / (std::numbers::pi / 3), 1.0);
    const double turn = link.joint <= 2 ? delta_theta : 0;
    const Vector3d t = from_spherical<double>({-(c.theta + turn), c.phi, c.rho + anchored * delta_r});
    const Vector3d p =
        profile.T_palm_sphere.inverse() * (T[link.joint] * (link.T_joint_link * c.p_link)) / profile.radius;
    sum += c.weight * dot(p - t, p - t);
  }
  return sum;
}

std::vector<double> uniform_action(double delta_r) {
  std::vector<double> action(15, delta_r);
  std::fill_n(action.begin(), 5, 0.0);
  return action;
}

}  // namespace

TEST_CASE("the zero action is a fixed point of the correspondence rule") {
  const HandProfile profile = test::small_profile();
  for (int passes : {1, 2, 5}) {
    const std::vector<double> q = solve(profile, std::vector<double>(15, 0.0),
                                        {.rule = CascadeRule::correspondence,
                                         .closing = CascadeClosing::fade,
                                         .field = FieldReading::finger,
                                         .passes = passes});
    for (std::size_t i = 0; i < q.size(); ++i)
      CHECK(q[i] == doctest::Approx(profile.joint_traits[i].q_sphere).epsilon(1e-9));
  }
}

TEST_CASE("mimic followers follow and lateral joints obey the table") {
  const HandProfile profile = test::small_profile();
  std::vector<double> action(15, 0.2);
  std::fill_n(action.begin(), 4, -0.1);
  const std::vector<double> q = solve(profile, action);
  CHECK(q[2] == doctest::Approx(0.8 * q[1] + 0.05));
  CHECK(q[0] == doctest::Approx(look_up_lateral<double>(profile.lateral_tables[0].inverse_q,
                                                        profile.lateral_tables[0].delta_theta_lower,
                                                        profile.lateral_tables[0].delta_theta_upper, -0.1)));
}

TEST_CASE("many passes end in a minimum of the weighted squared distance") {
  const HandProfile profile = test::small_profile();
  for (double delta_r : {-0.15, 0.1, 0.2}) {
    const std::vector<double> q = solve(profile, uniform_action(delta_r),
                                        {.rule = CascadeRule::correspondence,
                                         .closing = CascadeClosing::fade,
                                         .field = FieldReading::finger,
                                         .passes = 100});
    const double best = cost(profile, q, 0, delta_r);
    for (int joint : {1, 3, 4}) {
      for (double step : {-1e-3, 1e-3}) {
        std::vector<double> moved = q;
        moved[joint] += joint == 4 ? 0.08 * step : step;
        const Joint& j = profile.tree.joints[joint];
        if (moved[joint] < j.lower || moved[joint] > j.upper) continue;
        apply_mimics(profile.tree, moved);
        CAPTURE(joint);
        CAPTURE(delta_r);
        CHECK(cost(profile, moved, 0, delta_r) >= best - 1e-12);
      }
    }
  }
}

TEST_CASE("full contraction closes every encompassing joint and reports it") {
  const HandProfile profile = test::small_profile();
  for (CascadeClosing closing : {CascadeClosing::fade, CascadeClosing::hard}) {
    CascadeSolver<double> solver(
        profile, {.rule = CascadeRule::correspondence, .closing = closing, .field = FieldReading::finger, .passes = 1});
    std::vector<double> q(solver.joint_count());
    std::vector<std::uint8_t> closed(q.size());
    SolveReport report{.residual_rms = 0, .at_limit = {}, .closed = closed};
    const std::vector<double> action = uniform_action(-2);
    REQUIRE(solver.solve({.values = action}, q, report) == Status::ok);
    for (int joint : {1, 3, 4}) {
      CAPTURE(joint);
      if (closing == CascadeClosing::fade) CHECK(q[joint] == profile.joint_traits[joint].q_closed);
      if (closing == CascadeClosing::fade) CHECK(closed[joint] == 1);
    }
    if (closing == CascadeClosing::fade) CHECK(std::isnan(report.residual_rms));
  }
}

TEST_CASE_TEMPLATE("a slide at a limit is not beyond it by a rounding error", Real, float, double) {
  constexpr int slide = 4;
  std::mt19937_64 random(3);
  for (int n = 0; n < 200; ++n) {
    HandProfile profile = test::small_profile();
    Joint& joint = profile.tree.joints[slide];
    REQUIRE(joint.kind == JointKind::prismatic);
    joint.upper = profile.joint_traits[slide].q_closed = std::uniform_real_distribution<double>(0.015, 0.03)(random);
    for (Real delta_r : {Real(-2), Real(2)}) {
      const std::vector<Real> action(15, delta_r);
      CascadeSolver<Real> solver(profile);
      std::vector<Real> q(solver.joint_count());
      const auto check = [&](Status status) {
        REQUIRE(status == Status::ok);
        CHECK(q[slide] >= Real(joint.lower));
        CHECK(q[slide] <= Real(joint.upper));
      };
      check(solver.solve({.values = action}, q));
      for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2}) {
        if (!is_available(set)) continue;
        BatchSolver<Real> batch(profile, {}, {.threads = 1, .instruction_set = set});
        check(batch.solve({.count = 1, .values = action}, q));
      }
    }
  }
}

TEST_CASE("the residual of a report is the weighted rms distance") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  std::vector<double> q(solver.joint_count());
  SolveReport report;
  const std::vector<double> action = uniform_action(0.2);
  REQUIRE(solver.solve({.values = action}, q, report) == Status::ok);
  double weight = 0;
  for (const Correspondence& c : profile.correspondences) weight += profile.links[c.link].joint >= 0 ? c.weight : 0;
  CHECK(report.residual_rms == doctest::Approx(std::sqrt(cost(profile, q, 0, 0.2) / weight)));
}

TEST_CASE("a mirror image of a left hand solves like the right hand") {
  const HandProfile left = test::small_profile(), right = test::mirror_image(left);
  std::mt19937_64 random(4);
  for (int n = 0; n < 200; ++n) {
    const std::vector<double> action = test::random_action(random, 0.5, 1.5);
    for (FieldReading field : {FieldReading::finger, FieldReading::field}) {
      const std::vector<double> a =
          solve(left, action,
                {.rule = CascadeRule::correspondence, .closing = CascadeClosing::fade, .field = field, .passes = 2});
      const std::vector<double> b =
          solve(right, action,
                {.rule = CascadeRule::correspondence, .closing = CascadeClosing::fade, .field = field, .passes = 2});
      for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(1e-9));
    }
  }
}

TEST_CASE("a copy solves like its original, however it is made") {
  const HandProfile profile = test::small_profile();
  const std::vector<double> action = uniform_action(0.1), expected = solve(profile, action, {.passes = 3});
  const auto check = [&](CascadeSolver<double>& solver) {
    std::vector<double> q(solver.joint_count());
    REQUIRE(solver.solve({.values = action}, q) == Status::ok);
    CHECK(q == expected);
  };
  CascadeSolver<double> original(profile, {.passes = 3}), copy(original), assigned(test::arch_profile());
  assigned = original;
  check(copy);
  check(assigned);
  CascadeSolver<double> moved(std::move(copy));
  check(moved);
  copy = std::move(assigned);  // a solver that was moved from may be given another
  check(copy);
  check(original);
}

TEST_CASE("a report whose spans do not fit is refused, and nothing is written") {
  CascadeSolver<double> solver(test::small_profile());
  const std::vector<double> action = uniform_action(0.1);
  std::vector<double> q(solver.joint_count(), 77.0);
  std::vector<std::uint8_t> flags(q.size() - 1, 77);
  SolveReport at_limit{.at_limit = flags, .closed = {}}, closed{.at_limit = {}, .closed = flags};
  CHECK(solver.solve({.values = action}, q, at_limit) == Status::wrong_size);
  CHECK(solver.solve({.values = action}, q, closed) == Status::wrong_size);
  CHECK(std::ranges::count(q, 77.0) == static_cast<std::ptrdiff_t>(q.size()));
  CHECK(std::ranges::count(flags, 77) == static_cast<std::ptrdiff_t>(flags.size()));
}

TEST_CASE("options out of range are refused") {
  CHECK_THROWS_AS(CascadeSolver<double>(test::small_profile(), {.passes = 0}), Error);
  CHECK_THROWS_AS(CascadeSolver<double>(test::small_profile(), {.passes = 101}), Error);
}
