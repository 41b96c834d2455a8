// Tables of fingers whose azimuth is known in closed form.
#include "uhas/lateral_tables/lateral_tables.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/error_check.hpp"
#include "support/sphere_hand.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// Tables with the named joints lateral; the others close at their upper ends.
LateralTables build(const SphereHand& hand, const std::vector<int>& lateral, const LateralTableOptions& options = {}) {
  std::vector<double> q_closed;
  for (const Joint& joint : hand.anatomy.tree.joints) q_closed.push_back(joint.upper);
  return build_lateral_tables(hand.anatomy, hand.frame, classes_with(hand, lateral), q_closed, options);
}

int add_turn(SphereHand& hand, int parent, Vector3d origin, double lower, double upper) {
  return add_hinge(hand.tree(), parent, origin, {0, 0, 1}, lower, upper);
}

/// A finger of nothing but a joint that turns its tip on a circle of radius `arm` about an upright axis at
/// x = `axis_x`.
SphereHand rod(double axis_x, double arm, double lower, double upper) {
  SphereHand hand;
  hand.add_finger({add_turn(hand, -1, {axis_x, 0, -1}, lower, upper)}, {axis_x + arm, 0, -1});
  return hand;
}

double rod_azimuth(double axis_x, double arm, double q) {
  return std::atan2(arm * std::sin(q), axis_x + arm * std::cos(q));
}

/// Every sample of the table against the azimuth told, and the way back from there.
void check_table(const LateralTable& table, const std::function<double(double)>& azimuth) {
  CHECK(std::is_sorted(table.q.begin(), table.q.end()));
  CHECK(std::abs(wrap_angle(table.theta_initial - azimuth(table.neutral))) < 1e-9);
  CHECK(table.delta_theta_lower == std::min(table.theta.front(), table.theta.back()) - table.theta_initial);
  CHECK(table.delta_theta_upper == std::max(table.theta.front(), table.theta.back()) - table.theta_initial);
  const auto look_up = [&](double delta) {
    return look_up_lateral<double>(table.inverse_q, table.delta_theta_lower, table.delta_theta_upper, delta);
  };
  CHECK(look_up(0) == table.neutral);
  for (std::size_t i = 0; i < table.q.size(); ++i) {
    CAPTURE(table.q[i]);
    CHECK(std::abs(wrap_angle(table.theta[i] - azimuth(table.q[i]))) < 1e-9);
    if (i > 0) CHECK((table.theta[i] > table.theta[i - 1]) == (table.theta.back() > table.theta.front()));
    CHECK(std::abs(look_up(table.theta[i] - table.theta_initial) - table.q[i]) < 1e-3);
  }
}

}  // namespace

TEST_CASE("about the sphere's axis azimuth is the joint value; neutral is mid-range") {
  const LateralTables found = build(rod(0, 1, -0.3, 0.5), {0});
  REQUIRE(found.table_of_finger == std::vector<int>{0});
  const LateralTable& table = found.tables[0];
  check_table(table, [](double q) { return q; });
  CHECK(table.joint == 0);
  CHECK(table.q.size() == 201);
  CHECK(table.q.front() == -0.3);
  CHECK(table.q.back() == 0.5);
  CHECK(table.neutral == doctest::Approx(0.1));
  CHECK(table.delta_theta_lower == doctest::Approx(-0.4));
  CHECK(table.delta_theta_upper == doctest::Approx(0.4));
  CHECK(found.q_sphere == std::vector<double>{table.neutral});
  CHECK(found.warnings.empty());
}

TEST_CASE("the table holds the azimuth of the wrapped fingertip") {
  // the fingertip c + L cos(f) u(q), -1 + L sin(f) is on the sphere where A cos f - sin f = -K, with A = c cos q
  const double c = 0.3, L = 1.0, K = (c * c + L * L) / (2 * L);
  SphereHand hand;
  const int side = add_turn(hand, -1, {c, 0, -1}, -0.3, 0.7);
  add_planar_finger(hand, {.root = {c, 0, -1}, .lengths = {L}}, {side});
  const auto flexion = [&](double q) {
    const double A = c * std::cos(q);
    return std::acos(-K / std::hypot(A, 1)) - std::atan2(1, A);
  };
  const LateralTables found = build(hand, {side});
  const LateralTable& table = found.tables.at(0);
  check_table(table, [&](double q) {
    const double reach = L * std::cos(flexion(q));
    return std::atan2(reach * std::sin(q), c + reach * std::cos(q));
  });
  CHECK(table.neutral == doctest::Approx(0.2));
  CHECK(found.q_sphere[1] == doctest::Approx(flexion(0.2)).epsilon(1e-9));
  CHECK(to_spherical(hand.tip(0, found.q_sphere)).azimuth == doctest::Approx(table.theta_initial).epsilon(1e-9));
}

TEST_CASE("the table ends short of a turning point, and neutral is the middle of what is left") {
  const double c = 0.8, R = 0.5, lower = -0.5, upper = 2.8;
  const auto rate = [&](double q) { return (R * R + c * R * std::cos(q)) / (c * c + R * R + 2 * c * R * std::cos(q)); };
  constexpr int steps = 200;
  std::vector<double> magnitudes;
  for (int k = 0; k < steps; ++k) magnitudes.push_back(std::abs(rate(lower + (upper - lower) * (k + 0.5) / steps)));
  std::nth_element(magnitudes.begin(), magnitudes.begin() + steps / 2, magnitudes.end());
  double cut = lower;
  while (rate(cut) > 0.05 * magnitudes[steps / 2]) cut += 1e-4;
  REQUIRE(cut < std::acos(-R / c));

  const LateralTables found = build(rod(c, R, lower, upper), {0});
  const LateralTable& table = found.tables.at(0);
  check_table(table, [&](double q) { return rod_azimuth(c, R, q); });
  const double step = (upper - lower) / steps;
  CHECK(std::abs(table.q.front() - lower) <= step);
  CHECK(std::abs(table.q.back() - cut) <= step);
  CHECK(std::abs(table.neutral - (lower + cut) / 2) <= step);
  CHECK(found.q_sphere == std::vector<double>{table.neutral});
}

TEST_CASE("a continuous joint goes once around; theta_initial is wrapped, the table is not") {
  const double at_zero = 2.9, open = 0.4;
  SphereHand hand;
  const int side = add_turn(hand, -1, {0, 0, -1}, open - kPi, open + kPi);
  hand.tree().joints[side].kind = JointKind::continuous;
  hand.add_finger({side}, {std::cos(at_zero), std::sin(at_zero), -1});
  hand.anatomy.q_open = {open};
  const LateralTables found = build(hand, {side});
  const LateralTable& table = found.tables.at(0);
  check_table(table, [&](double q) { return at_zero + q; });
  CHECK(table.neutral == doctest::Approx(open));
  CHECK(table.theta_initial == doctest::Approx(at_zero + open - 2 * kPi));
  CHECK(table.delta_theta_lower == doctest::Approx(-kPi));
  CHECK(table.delta_theta_upper == doctest::Approx(kPi));
}

TEST_CASE("a mirrored hand has the same canonical tables") {
  SphereHand hand;
  const int side = add_turn(hand, -1, {0.3, 0.1, -1}, -0.3, 0.7);
  add_planar_finger(hand, {}, {side});
  const LateralTables right = build(hand, {side}), left = build(mirrored(hand), {side});
  const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(std::abs(a[i] - b[i]) < 1e-9);
  };
  same(left.tables.at(0).q, right.tables[0].q);
  same(left.tables[0].theta, right.tables[0].theta);
  same(left.tables[0].inverse_q, right.tables[0].inverse_q);
  same(left.q_sphere, right.q_sphere);
  CHECK(left.tables[0].theta_initial == doctest::Approx(right.tables[0].theta_initial));
}

TEST_CASE("the widest of several lateral joints drives the finger, the others stay at neutral") {
  SphereHand hand;
  const int narrow = add_turn(hand, -1, {0, 0, -1}, -0.1, 0.3), wide = add_turn(hand, narrow, {0, 0, -1}, -0.2, 0.6);
  hand.add_finger({narrow, wide}, {1, 0, -1});
  const LateralTables found = build(hand, {narrow, wide});
  REQUIRE(found.tables.size() == 2);
  const LateralTable& driver = found.tables[found.table_of_finger.at(0)];
  CHECK(driver.joint == wide);
  check_table(driver, [](double q) { return q + 0.1; });
  CHECK(driver.theta_initial == doctest::Approx(0.2 + 0.1));
  CHECK(found.q_sphere[narrow] == doctest::Approx(0.1));
  CHECK(found.q_sphere[wide] == doctest::Approx(0.2));
}

TEST_CASE("a joint that hardly moves its tip does not drive, however wide its azimuth range") {
  // near the pole a small roll sweeps a wide azimuth: 168 degrees against the side joint's 140
  for (const double off_axis : {0.2, 0.4}) {
    const bool roll_drives = off_axis > 0.3;
    SphereHand hand;
    const int side = add_turn(hand, -1, {-1, 0, -1}, -0.05, 0.05);
    const int roll = add_hinge(hand.tree(), side, {-1, 0, -1}, {1, 0, 0}, -1.2, 1.2);
    hand.add_finger({side, roll}, {0.02, 0, -1 + off_axis});
    const LateralTables found = build(hand, {side, roll});
    REQUIRE(found.tables.size() == 2);
    CAPTURE(off_axis);
    CHECK(found.tables[1].delta_theta_upper > found.tables[0].delta_theta_upper);
    CHECK(found.tables[found.table_of_finger.at(0)].joint == (roll_drives ? roll : side));
    CHECK(std::abs(found.q_sphere[roll_drives ? side : roll]) < 1e-9);
  }
}

TEST_CASE("fingers without a table: no lateral joint, one that does not turn the tip, one that another finger owns") {
  SphereHand hand;
  add_planar_finger(hand, {});
  const int idle = add_turn(hand, -1, {0, 0, -1}, -0.2, 0.6);
  hand.add_finger({idle}, {0, 0, -1});
  const int arch = add_turn(hand, -1, {0, 0, -1}, -0.2, 0.2);
  hand.add_finger({arch}, {0.8, 0.2, -1});
  hand.add_finger({arch}, {0.8, -0.2, -1});
  const LateralTables found = build(hand, {idle, arch});
  CHECK(found.table_of_finger == std::vector<int>{-1, -1, 0, -1});
  REQUIRE(found.tables.size() == 1);
  CHECK(found.tables[0].joint == arch);
  CHECK(found.q_sphere[idle] == doctest::Approx(0.2));
}

TEST_CASE("an azimuth that only jumps, as the tip runs through the sphere's axis, is no table") {
  SphereHand hand;
  const int slide = add_slide(hand.tree(), -1, {0.5, 0, -1}, {1, 0, 0}, -0.8, 0.2);
  hand.add_finger({slide}, {0.5, 0, -1});
  const LateralTables found = build(hand, {slide});
  CHECK(found.tables.empty());
  CHECK(found.table_of_finger == std::vector<int>{-1});
  CHECK(found.q_sphere[slide] == doctest::Approx(-0.3));
}

TEST_CASE("a side with little room is warned of") {
  // as the tip passes near the pole the azimuth runs fast: 30 degrees below neutral, 162 above
  const double c = 0.45, R = 0.5;
  const LateralTables found = build(rod(c, R, 1.6, 3.3), {0});
  check_table(found.tables.at(0), [&](double q) { return rod_azimuth(c, R, q); });
  REQUIRE(found.warnings.size() == 1);
  CHECK(found.warnings[0] == "finger finger1: joint 'j0' leaves little room for delta theta on one side of neutral");
  CHECK(build(rod(c, R, 0.6, 2.3), {0}).warnings.empty());
}

TEST_CASE("the scale of the hand changes no table") {
  SphereHand hand;
  const int side = add_turn(hand, -1, {0.3, 0.1, -1}, -0.3, 0.7);
  add_planar_finger(hand, {}, {side});
  const LateralTable one = build(hand, {side}).tables.at(0);
  for (const double factor : {0.01, 50.0}) {
    const LateralTable other = build(scaled(hand, factor), {side}).tables.at(0);
    REQUIRE(other.theta.size() == one.theta.size());
    for (std::size_t i = 0; i < one.theta.size(); ++i) CHECK(std::abs(other.theta[i] - one.theta[i]) < 1e-9);
    CHECK(other.neutral == doctest::Approx(one.neutral));
  }
}

TEST_CASE("the number of steps is the table's, and eleven is the least") {
  CHECK(build(rod(0, 1, -0.3, 0.5), {0}, {.steps = 11}).tables.at(0).q.size() == 11);
  check_error(ErrorCode::invalid_config, "10 steps", [] { build(rod(0, 1, -0.3, 0.5), {0}, {.steps = 10}); });
}
