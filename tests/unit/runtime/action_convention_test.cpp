// What an action's numbers mean: conventions, and what a single call may change of them.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/arch_profile.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/runtime/cascade/action_decoder.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/encoder.hpp"

using namespace uhas;

namespace {

std::vector<double> solve(const HandProfile& profile, const Action<double>& action, const SolveOptions& options = {}) {
  CascadeSolver<double> solver(profile, options);
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve(action, q) == Status::ok);
  return q;
}

void check_equal(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(1e-9));
}

std::vector<double> uniform_action(double radial) {
  std::vector<double> action(15, radial);
  std::fill_n(action.begin(), kSlotCount, 0.0);
  return action;
}

}  // namespace

TEST_CASE("a radius is a displacement from 1, and azimuth may count the other way round") {
  const HandProfile profile = test::small_profile();
  std::mt19937_64 random(1);
  for (int n = 0; n < 50; ++n) {
    const std::vector<double> own = test::random_action(random, 0.3, 0.9);
    std::vector<double> radii = own, turned = own;
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i < kSlotCount)
        turned[i] = -own[i];
      else
        radii[i] = 1 + own[i];
    }
    check_equal(solve(profile, {.values = radii}, {.convention = {.absolute_radii = true}}),
                solve(profile, {.values = own}));
    check_equal(solve(profile, {.values = turned}, {.convention = {.azimuth_sign = -1}}),
                solve(profile, {.values = own}));
  }
}

TEST_CASE("a profile held toward the pole has the first vector's displacement there") {
  const std::vector<double> values(15, 0.4);
  const ActionNumbers<double> numbers{.values = values.data(), .phi = nullptr, .vectors = 2};
  std::array<PlaneDeformation<double>, 2> planes;
  ActionDecoder<double>(test::small_profile(), {.held_toward_pole = true}).decode(numbers, planes.data());
  for (double phi : {0.0, 0.3, 1.0, 2.0, 3.0}) CHECK(planes[1].at(phi).delta_r == 0.4);
  ActionDecoder<double>(test::small_profile()).decode(numbers, planes.data());
  CHECK(planes[1].at(0).delta_r == doctest::Approx(0));
}

TEST_CASE("the released simulation's convention: fingertips come to rest on the sphere of the given radius") {
  const HandProfile profile = test::arch_profile();
  for (double radius : {0.9, 1.0, 1.05}) {
    const std::vector<double> q = solve(profile, {.values = uniform_action(radius)}, kUhasSim);
    std::vector<RigidTransformd> T(q.size());
    forward_kinematics(profile.tree, q, T);
    for (const ProfileFinger& finger : profile.fingers) {
      const int joint = finger.joints.back();
      const Joint& limits = profile.tree.joints[joint];
      CAPTURE(finger.name);
      CAPTURE(radius);
      CHECK(q[joint] > limits.lower + 1e-6);
      CHECK(q[joint] < limits.upper - 1e-6);
      const Vector3d tip = profile.T_palm_sphere.inverse() * (T[joint] * finger.p_tip_link);
      CHECK(norm(tip) / profile.radius == doctest::Approx(radius).epsilon(1e-6));
    }
  }
  const std::vector<double> closed = solve(profile, {.values = uniform_action(-0.1)}, kUhasSim);
  for (std::size_t i = 0; i < closed.size(); ++i) CHECK(closed[i] == profile.joint_traits[i].q_closed);
}

TEST_CASE("an azimuth offset turns a finger as its own number would, within the same bounds") {
  const HandProfile profile = test::small_profile();
  const LateralTable& table = profile.lateral_tables[0];
  const std::vector<double> offsets{0.05, 0.05, 0.05, 0.05, 0.2};
  std::vector<double> action(15, 0.1), expected = action;
  for (int slot = 0; slot < 4; ++slot) expected[slot] = 0.15;
  check_equal(solve(profile, {.values = action, .azimuth_offsets = offsets}), solve(profile, {.values = expected}));

  for (int slot = 0; slot < 4; ++slot)
    action[slot] = 1, expected[slot] = table.delta_theta_upper;  // normalised: the upper end
  const std::vector<double> inward(5, -0.05), outward(5, 0.5);
  Action<double> normalized{.values = action, .normalized = true, .azimuth_offsets = outward};
  CHECK(solve(profile, normalized)[0] == doctest::Approx(table.inverse_q.back()));
  normalized.azimuth_offsets = inward;
  for (int slot = 0; slot < 4; ++slot) expected[slot] = table.delta_theta_upper - 0.05;
  CHECK(solve(profile, normalized)[0] == doctest::Approx(solve(profile, {.values = expected})[0]));
}

TEST_CASE("a call may have radial bounds of its own") {
  const HandProfile profile = test::small_profile();
  const std::vector<double> narrow{-0.3, 0.2}, far = uniform_action(-1.7);
  check_equal(solve(profile, {.values = far, .radial_bounds = narrow}),
              solve(profile, {.values = uniform_action(-0.3)}));
  const std::vector<double> full = uniform_action(0.5), low = uniform_action(-0.5);
  check_equal(solve(profile, {.values = full, .normalized = true, .radial_bounds = narrow}),
              solve(profile, {.values = uniform_action(0.1)}));
  check_equal(solve(profile, {.values = low, .normalized = true, .radial_bounds = narrow}),
              solve(profile, {.values = uniform_action(-0.15)}));
}

TEST_CASE("offsets and bounds that cannot be are refused") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  std::vector<double> q(5, 77.0);
  const std::vector<double> action(15, 0.1), four(4, 0.0), not_finite{0, 0, NAN, 0, 0}, above{0.1, 0.2},
      below{-0.2, -0.1}, far{-1, 1e307}, one{0.0};
  const std::vector<double> infinite{-1, std::numeric_limits<double>::infinity()};
  CHECK(solver.solve({.values = action, .azimuth_offsets = four}, q) == Status::wrong_size);
  CHECK(solver.solve({.values = action, .azimuth_offsets = not_finite}, q) == Status::non_finite_input);
  CHECK(solver.solve({.values = action, .radial_bounds = above}, q) == Status::invalid_radial_bounds);
  CHECK(solver.solve({.values = action, .radial_bounds = below}, q) == Status::invalid_radial_bounds);
  CHECK(solver.solve({.values = action, .radial_bounds = far}, q) == Status::invalid_radial_bounds);
  CHECK(solver.solve({.values = action, .radial_bounds = one}, q) == Status::wrong_size);
  CHECK(solver.solve({.values = action, .radial_bounds = infinite}, q) == Status::non_finite_input);
  CHECK(q == std::vector<double>(5, 77.0));
}

TEST_CASE("conventions that cannot be are refused") {
  const HandProfile profile = test::small_profile();
  CHECK_THROWS_AS(CascadeSolver<double>(profile, {.convention = {.azimuth_sign = 0}}), Error);
  CHECK_THROWS_AS(CascadeSolver<double>(profile, {.convention = {.radial_lower = 0.5}}), Error);
  CHECK_THROWS_AS(CascadeSolver<double>(profile, {.convention = {.radial_upper = NAN}}), Error);
  CHECK_THROWS_AS(Encoder<double>(profile, kUhasSim), Error);
}
