// Joint classes on joints whose fingertip paths are known in closed form.
#include "uhas/classification/joint_classes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "support/sphere_hand.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

struct Motion {
  double lateral = 0, encompassing = 0;
};

/// Motion along a path, from the velocity alone: the part across is that along z x p, the rest is encompassing.
Motion motion_along(const std::function<Vector3d(double)>& path, double first, double last) {
  constexpr int steps = 20000;
  Motion motion;
  for (int k = 0; k < steps; ++k) {
    const Vector3d a = path(first + (last - first) * k / steps), b = path(first + (last - first) * (k + 1) / steps);
    const Vector3d across = normalized(cross(Vector3d{0, 0, 1}, a + b));
    motion.lateral += std::abs(dot(across, b - a));
    motion.encompassing += norm(orthogonal_part(b - a, across));
  }
  return motion;
}

/// A hand with one finger of one joint.
SphereHand one_hinge(Vector3d origin, Vector3d axis, Vector3d tip, double lower = -2, double upper = 2) {
  SphereHand hand;
  hand.add_finger({add_hinge(hand.tree(), -1, origin, axis, lower, upper)}, tip);
  return hand;
}

std::vector<JointClassification> classify(const SphereHand& hand, std::vector<double> q_closed = {}) {
  q_closed.resize(hand.anatomy.tree.joints.size());
  return classify_joints(hand.anatomy, hand.frame, q_closed);
}

void check_motion(const JointClassification& found, const Motion& expected, double tolerance = 1e-4) {
  CHECK(std::abs(found.lateral_motion - expected.lateral) <= tolerance);
  CHECK(std::abs(found.encompassing_motion - expected.encompassing) <= tolerance);
  CHECK((found.joint_class == JointClass::lateral) == (expected.lateral > expected.encompassing));
  CHECK(found.margin ==
        doctest::Approx(std::abs(expected.lateral - expected.encompassing) / (expected.lateral + expected.encompassing))
            .epsilon(1e-3));
}

}  // namespace

TEST_CASE("about the sphere's axis all motion is lateral: the tip's distance from the axis times the angle") {
  const Vector3d tip{0.6, 0, -0.8};
  check_motion(classify(one_hinge({0, 0, -1}, {0, 0, 1}, tip))[0], {0.6 * 1.0, 0});
  // within the limits only, and about the open pose
  check_motion(classify(one_hinge({0, 0, -1}, {0, 0, 1}, tip, -0.2, 0.3))[0], {0.6 * 0.5, 0});
  SphereHand hand = one_hinge({0, 0, -1}, {0, 0, 1}, tip, -0.2, 2);
  hand.anatomy.q_open = {1.8};
  check_motion(classify(hand)[0], {0.6 * 0.7, 0});
}

TEST_CASE("across the sphere's axis all motion is encompassing: the arm times the angle") {
  check_motion(classify(one_hinge({0, 0, 0}, {0, 1, 0}, {0.6, 0, -0.8}))[0], {0, 1.0});
  check_motion(classify(one_hinge({0.3, 0, -1}, {0, -1, 0}, {1.5, 0, -1}))[0], {0, 1.2});
}

TEST_CASE("a slanting axis shares the motion as the velocities say") {
  const Vector3d tip{1.3, 0.1, -0.9};
  for (const double slant : {0.3, 0.7, 0.9, 1.2}) {
    const Vector3d origin{0.4, 0, -1}, axis{0, std::sin(slant), std::cos(slant)};
    const auto path = [&](double q) { return origin + Rotationd::about(axis, q) * (tip - origin); };
    CAPTURE(slant);
    const JointClassification found = classify(one_hinge(origin, axis, tip))[0];
    check_motion(found, motion_along(path, -0.5, 0.5));
    CHECK(!found.flexed_probe);
  }
}

TEST_CASE("a sliding joint goes half a radius to both sides") {
  const auto slide = [](Vector3d axis) {
    SphereHand hand;
    hand.add_finger({add_slide(hand.tree(), -1, {1, 0, 0}, axis, -3, 3)}, {1, 0, 0});
    return hand;
  };
  check_motion(classify(slide({1, 0, 0}))[0], {0, 1});
  const Motion across{2 * std::asinh(0.5), 2 * (std::sqrt(1.25) - 1)};
  check_motion(classify(slide({0, 1, 0}))[0], across);
  check_motion(classify(scaled(slide({0, 1, 0}), 0.1))[0], {0.1 * across.lateral, 0.1 * across.encompassing});
}

TEST_CASE("a joint whose axis points at the fingertip is judged with the finger flexed by 30 % of its way") {
  SphereHand hand;
  const double x = 0.2, lengths[] = {0.7, 0.5};
  const int roll = add_hinge(hand.tree(), -1, {x, 0, -1}, {1, 0, 0}, -1, 1);
  add_planar_finger(hand, {.root = {x, 0, -1}, .lengths = {lengths[0], lengths[1]}}, {roll});
  hand.anatomy.q_open = {0, 0.1, 0};
  const std::vector<double> q_closed{1, 1.6, 1.2};

  // at the open pose the tip is off the axis by sin(0.1) of its arm
  const double first = 0.1 + 0.3 * 1.5, second = first + 0.3 * 1.2;
  const double along = x + lengths[0] * std::cos(first) + lengths[1] * std::cos(second);
  const double off_axis = lengths[0] * std::sin(first) + lengths[1] * std::sin(second);
  const auto path = [&](double q) { return Vector3d{along, -off_axis * std::sin(q), -1 + off_axis * std::cos(q)}; };

  const std::vector<JointClassification> classes = classify(hand, q_closed);
  CHECK(classes[0].flexed_probe);
  check_motion(classes[0], motion_along(path, -0.5, 0.5));
  CHECK(!classes[1].flexed_probe);
  CHECK(!classes[2].flexed_probe);
}

TEST_CASE("the flexed probe begins where the tip moves less than 0.3 of its arm") {
  for (const double share : {0.29, 0.31}) {
    const Vector3d axis{std::sqrt(1 - share * share), share, 0};
    CAPTURE(share);
    CHECK(classify(one_hinge({0.3, 0, -1}, axis, {1.3, 0, -1}))[0].flexed_probe == (share < 0.3));
  }
}

TEST_CASE("a joint that moves two fingers is judged by both tips, and followers have their master's class") {
  SphereHand hand;
  const int arch = add_hinge(hand.tree(), -1, {0, 0, -1}, {0, 0, 1}, -1, 1);
  const int follower = add_follower(hand.tree(), arch, {0.3, 0, -1}, {0, -1, 0}, arch, 0);
  hand.add_finger({arch}, {0.8, 0, -1});
  hand.add_finger({arch, follower}, {0.6, 0.5, -1});
  const std::vector<JointClassification> classes = classify(hand);
  check_motion(classes[arch], {0.8 + std::hypot(0.6, 0.5), 0});
  CHECK(classes[follower].joint_class == JointClass::lateral);
  CHECK(classes[follower].lateral_motion == classes[arch].lateral_motion);
  CHECK(classes[follower].margin == classes[arch].margin);
}

TEST_CASE("a master is judged with its followers in motion") {
  // alone the master would turn the tip about the sphere's axis; its follower outweighs that
  SphereHand hand;
  const int master = add_hinge(hand.tree(), -1, {0, 0, -1}, {0, 0, 1}, -0.5, 0.5);
  const int follower = add_follower(hand.tree(), master, {0.3, 0, -1}, {0, -1, 0}, master, 2);
  hand.add_finger({master, follower}, {0.8, 0, -1});
  const auto path = [](double q) {
    const double reach = 0.3 + 0.5 * std::cos(2 * q);
    return Vector3d{reach * std::cos(q), reach * std::sin(q), -1 + 0.5 * std::sin(2 * q)};
  };
  check_motion(classify(hand)[master], motion_along(path, -0.5, 0.5));
}

TEST_CASE("motions are lengths: they grow with the hand, classes and margins stay") {
  SphereHand hand;
  const int side = add_hinge(hand.tree(), -1, {0.1, 0, -1}, {0, 0, 1}, -0.4, 0.5);
  add_planar_finger(hand, {}, {side});
  const std::vector<double> q_closed{0.5, 1.8, 1.8, 1.8};
  const auto small = classify(hand, q_closed), large = classify(scaled(hand, 40), q_closed);
  for (std::size_t i = 0; i < small.size(); ++i) {
    CHECK(large[i].joint_class == small[i].joint_class);
    CHECK(large[i].margin == doctest::Approx(small[i].margin));
    CHECK(large[i].lateral_motion == doctest::Approx(40 * small[i].lateral_motion));
    CHECK(large[i].encompassing_motion == doctest::Approx(40 * small[i].encompassing_motion));
  }
  CHECK(small[side].joint_class == JointClass::lateral);
}

TEST_CASE("a joint whose axis goes through the fingertip has no margin, whatever rounding makes of its motion") {
  SphereHand hand;
  const std::vector<double> q_closed(1, 0.5);
  hand.add_finger({add_hinge(hand.tree(), -1, {0.3, 0.1, -1}, {1, 0, 0}, -0.5, 0.5)}, {1.2, 0.1 + 1e-9, -1});
  const JointClassification found = classify_joints(hand.anatomy, hand.frame, q_closed)[0];
  CHECK(found.margin == 0);
  CHECK(found.joint_class == JointClass::encompassing);
}

TEST_CASE("side joints further out stay open while the finger is flexed for a probe") {
  // a roll joint, a side joint and a flexion joint: only the last bends the finger that the first one swings
  SphereHand hand;
  const int roll = add_hinge(hand.tree(), -1, {0.3, 0, -1}, {1, 0, 0}, -0.5, 0.5);
  const int side = add_hinge(hand.tree(), roll, {0.3, 0, -1}, {0, 0, 1}, -1, 1);
  const int flexion = add_hinge(hand.tree(), side, {0.3, 0, -1}, {0, -1, 0}, -0.5, 1.8);
  hand.add_finger({roll, side, flexion}, {1.2, 0, -1});
  const auto probe = [&](double side_closed) {
    return classify_joints(hand.anatomy, hand.frame, std::vector<double>{0.5, side_closed, 1.8})[roll];
  };
  REQUIRE(probe(1).flexed_probe);
  CHECK(probe(1).lateral_motion == probe(-1).lateral_motion);
  CHECK(probe(1).lateral_motion == probe(0).lateral_motion);
}
