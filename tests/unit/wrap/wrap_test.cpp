// Wraps against plane geometry: a rod that turns about a point meets the unit circle where the law of cosines says.
#include "uhas/wrap/wrap.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "support/sphere_hand.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// A point x + i z of the plane y = 0.
using Point = std::complex<double>;

/// Direction (rad, from +x toward +z) in which a rod from `p` first meets the unit circle, turning toward the centre.
double direction_to_circle(Point p, double length) {
  const double d = std::abs(p);
  return std::arg(-p) - std::acos((d * d + length * length - 1) / (2 * d * length));
}

/// Joint values of a planar finger whose every node lies on the circle.
std::vector<double> values_on_circle(const PlanarFinger& finger) {
  std::vector<double> q;
  Point at{finger.root.x, finger.root.z};
  double before = 0;
  for (double length : finger.lengths) {
    const double direction = direction_to_circle(at, length);
    q.push_back(finger.sign * (direction - before));
    at += std::polar(length, direction);
    before = direction;
  }
  return q;
}

/// Wraps the hand with every joint closing upward but for those in `q_closed`.
std::vector<double> wrap(const SphereHand& hand, const std::vector<double>& q_closed,
                         const std::vector<int>& lateral = {}, std::vector<double> q = {}) {
  q.resize(hand.anatomy.tree.joints.size());
  wrap_on_sphere(hand.anatomy, hand.frame, classes_with(hand, lateral), q_closed, q);
  return q;
}

std::vector<double> wrap(const PlanarFinger& finger) {
  SphereHand hand;
  add_planar_finger(hand, finger);
  return wrap(hand, std::vector<double>(finger.lengths.size(), finger.sign * finger.closing));
}

void check_same(const std::vector<double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(std::abs(found[i] - expected[i]) <= 1e-9);
  }
}

/// The first zero of `gap` in steps of 1e-4 from 0, halved down.
double first_zero(const std::function<double(double)>& gap) {
  double b = 0;
  while (gap(b) > 0 && b < 4) b += 1e-4;
  double a = b - 1e-4;
  for (int i = 0; i < 60; ++i) (gap((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
  return b;
}

}  // namespace

TEST_CASE("every node of a planar finger meets the circle where plane geometry says, whatever way it closes") {
  for (const double sign : {1.0, -1.0}) {
    const PlanarFinger finger{.sign = sign};
    check_same(wrap(finger), values_on_circle(finger));
    CHECK(sign * wrap(finger)[1] > 0);
  }
}

TEST_CASE("the open pose is where the way begins, not what is measured") {
  const PlanarFinger finger{.back = 0.5, .closing = 2.5};
  SphereHand hand;
  add_planar_finger(hand, finger);
  hand.anatomy.q_open = {0.2, -0.1, 0.3};
  check_same(wrap(hand, {2.5, 2.5, 2.5}), values_on_circle(finger));
}

TEST_CASE("a node inside at open turns outward to the sphere") {
  // the first node lands on (0.6, -0.8) from below, so that the second one starts inside
  const PlanarFinger finger{.root = {0.6, 0, -1}, .lengths = {0.2, 0.4, 0.3}, .back = 0.9};
  const std::vector<double> q = wrap(finger);
  CHECK(q[0] == doctest::Approx(std::numbers::pi / 2));
  CHECK(q[1] < 0);
  check_same(q, values_on_circle(finger));
}

TEST_CASE("without a root the value of least distance from the sphere is taken") {
  SUBCASE("the circle passes by: the node points at the centre") {
    const PlanarFinger finger{.root = {1.5, 0, -1}, .lengths = {0.3}, .closing = 3.0};
    CHECK(wrap(finger)[0] == doctest::Approx(std::atan2(1, -1.5)));
  }
  SUBCASE("the limit comes first") {
    CHECK(wrap({.root = {1.5, 0, -1}, .lengths = {0.3}, .closing = 1.8})[0] == doctest::Approx(1.8));
    CHECK(wrap({.root = {1.5, 0, -1}, .lengths = {0.3}, .closing = 1.8, .sign = -1})[0] == doctest::Approx(-1.8));
  }
  SUBCASE("a node inside cannot get out") {
    const std::vector<double> q = wrap({.root = {0.6, 0, -1}, .lengths = {0.2, 0.4}, .back = 0.3});
    CHECK(q[1] == doctest::Approx(-0.3));
  }
}

TEST_CASE("a mimic group puts its fingertip on the sphere at the first meeting") {
  const double lengths[] = {0.5, 0.4, 0.3}, share[] = {1, 0.8, 0.6};
  for (const double sign : {1.0, -1.0}) {
    SphereHand hand;
    const Vector3d axis{0, -sign, 0};
    const int master = add_hinge(hand.tree(), -1, {0.3, 0, -1}, axis, -1.5, 1.5);
    const int second = add_follower(hand.tree(), master, {0.8, 0, -1}, axis, master, share[1]);
    const int third = add_follower(hand.tree(), second, {1.2, 0, -1}, axis, master, share[2]);
    hand.add_finger({master, second, third}, {1.5, 0, -1});

    const double expected = first_zero([&](double q) {
      Point at{0.3, -1};
      double direction = 0;
      for (int i = 0; i < 3; ++i) at += std::polar(lengths[i], direction += share[i] * q);
      return std::abs(at) - 1;
    });
    check_same(wrap(hand, {sign * 1.5, 0, 0}), {sign * expected, sign * 0.8 * expected, sign * 0.6 * expected});
  }
}

TEST_CASE("a sliding finger stops on the sphere") {
  for (const double sign : {1.0, -1.0}) {
    SphereHand hand;
    const int slide =
        add_slide(hand.tree(), -1, {1.5, 0, -0.6}, {-sign, 0, 0}, std::min(0.0, sign), std::max(0.0, sign));
    hand.add_finger({slide}, {1.5, 0, -0.6});
    check_same(wrap(hand, {sign}), {sign * 0.7});
    check_same(wrap(scaled(hand, 0.01), {sign * 0.01}), {sign * 0.007});
  }
}

TEST_CASE("lateral joints keep the value they are given") {
  const PlanarFinger finger;
  SphereHand hand;
  const int side = add_hinge(hand.tree(), -1, {0, 0, -1}, {0, 0, 1}, -1, 1);
  add_planar_finger(hand, finger, {side});
  std::vector<double> expected = values_on_circle(finger);
  for (const double turn : {-0.4, 0.0, 0.7}) {
    const std::vector<double> q = wrap(hand, {1, 1.8, 1.8, 1.8}, {side}, {turn, 0.3, -0.4, 1.1});
    CHECK(q[0] == turn);
    check_same({q.begin() + 1, q.end()}, expected);
  }
}

TEST_CASE("a joint shared by two fingers is solved first, to a mean gap of zero") {
  const double half_width[] = {0.2, -0.3};
  SphereHand hand;
  const int arch = add_hinge(hand.tree(), -1, {0.3, 0, -1}, {0, -1, 0}, -0.5, 1.8);
  for (double y : half_width) {
    const int joint = add_hinge(hand.tree(), arch, {0.8, y, -1}, {0, -1, 0}, -1.0, 1.8);
    hand.add_finger({arch, joint}, {1.2, y, -1});
  }
  const double expected = first_zero([&](double q) {
    const Point node = Point{0.3, -1} + std::polar(0.5, q);
    return (std::hypot(std::abs(node), half_width[0]) + std::hypot(std::abs(node), half_width[1])) / 2 - 1;
  });
  const std::vector<double> q = wrap(hand, {1.8, 1.8, 1.8});
  CHECK(q[arch] == doctest::Approx(expected).epsilon(1e-9));
  for (int finger = 0; finger < 2; ++finger) CHECK(norm(hand.tip(finger, q)) == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("the scale of the hand changes no angle, the axes' signs change only theirs") {
  const PlanarFinger finger{.root = {0.6, 0, -1}, .lengths = {0.2, 0.4, 0.3}, .back = 0.9};
  SphereHand hand;
  const int side = add_hinge(hand.tree(), -1, {0.1, 0.05, -1}, {0, 0, 1}, -1, 1);
  add_planar_finger(hand, finger, {side});
  const std::vector<double> q_closed{1, 1.8, 1.8, 1.8}, start{0.3};
  for (const double factor : {1e-3, 0.08, 1e3})
    check_same(wrap(scaled(hand, factor), q_closed, {side}, start), wrap(hand, q_closed, {side}, start));
  check_same(wrap(mirrored(hand), q_closed, {side}, start), wrap(hand, q_closed, {side}, start));
}

TEST_CASE("a finger wrapped alone gets the values it has in the wrapped hand, the other fingers stay open") {
  // fingers 0 and 1 share the arch, and finger 2's last joint follows one of finger 1: all three hang together;
  // finger 3 is by itself
  SphereHand hand;
  const Vector3d axis{0, -1, 0};
  const int arch = add_hinge(hand.tree(), -1, {0.3, 0, -1}, axis, -0.5, 1.8);
  const int first = add_hinge(hand.tree(), arch, {0.8, 0.2, -1}, axis, -1.0, 1.8);
  const int second = add_hinge(hand.tree(), arch, {0.8, -0.3, -1}, axis, -1.0, 1.8);
  const int third = add_follower(hand.tree(), -1, {0.5, 0.1, -1}, axis, second, 0.9);
  hand.add_finger({arch, first}, {1.2, 0.2, -1});
  hand.add_finger({arch, second}, {1.2, -0.3, -1});
  hand.add_finger({third}, {1.3, 0.1, -1});
  const int lone = add_planar_finger(hand, {.root = {0.4, 0, -1}, .lengths = {0.4, 0.3}});
  hand.anatomy.q_open[first] = 0.1;
  const std::vector<double> q_closed(hand.anatomy.tree.joints.size(), 1.8);
  const auto classes = classes_with(hand, {});
  SphereWrapper wrapper(hand.anatomy, hand.frame, classes, q_closed);

  std::vector<double> whole(q_closed.size());
  wrapper.wrap(whole);
  CHECK(whole == wrap(hand, q_closed));
  for (int finger = 0; finger < int(hand.anatomy.fingers.size()); ++finger) {
    std::vector<double> expected = hand.anatomy.q_open, alone(q_closed.size(), 0.5);
    for (int other = 0; other < int(hand.anatomy.fingers.size()); ++other)
      if ((other == lone) == (finger == lone))
        for (int joint : hand.anatomy.fingers[other].joints) expected[joint] = whole[joint];
    wrapper.wrap_finger(finger, alone);
    CAPTURE(finger);
    CHECK(alone == expected);
  }
}
