#include "uhas/sphere_frame/sphere_frame.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "support/model_transforms.hpp"
#include "support/toy_hand.hpp"
#include "uhas/base/errors.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

int finger_named(const SphereFrame& frame, const std::string& name) {
  for (std::size_t i = 0; i < frame.names.size(); ++i)
    if (frame.names[i] == name) return static_cast<int>(i);
  return -1;
}

}  // namespace

TEST_CASE("centre, radius and axes of a hand known by construction") {
  const Anatomy anatomy = infer_anatomy(make_toy_hand());
  const SphereFrame frame = compute_sphere_frame(anatomy);
  // roots: four at z = 0.085, y = 0.022 .. -0.044, and the thumb's at (0, 0.03, 0.02)
  const Vector3d center{0, (0.022 - 0.022 - 0.044 + 0.03) / 5, (4 * 0.085 + 0.02) / 5};
  CHECK(norm(frame.palm_center_palm - center) < 1e-12);
  const double l = (norm(Vector3d{0, 0.022, 0.185} - center) + norm(Vector3d{0, 0, 0.185} - center) +
                    norm(Vector3d{0, -0.022, 0.185} - center) + norm(Vector3d{0, -0.044, 0.185} - center) +
                    norm(Vector3d{0, 0.13, 0.02} - center)) /
                   5;
  CHECK(frame.mean_tip_distance == doctest::Approx(l).epsilon(1e-6));
  CHECK(frame.radius == doctest::Approx(2 * l / std::numbers::pi).epsilon(1e-6));
  CHECK(norm(frame.T_palm_sphere.rotation.column(0) - Vector3d{0, 0, 1}) < 1e-3);
  CHECK(norm(frame.T_palm_sphere.rotation.column(1) - Vector3d{0, -1, 0}) < 1e-3);
  CHECK(norm(frame.T_palm_sphere.rotation.column(2) - Vector3d{1, 0, 0}) < 1e-3);
  CHECK(norm(frame.T_palm_sphere.translation - (center + frame.radius * frame.T_palm_sphere.rotation.column(2))) <
        1e-12);
  CHECK(frame.palm_plane_rms < 1e-4);
  CHECK(!frame.mirrored);
  CHECK(frame.open_azimuth[finger_named(frame, "thumb")] < 0);
  CHECK(frame.open_azimuth[finger_named(frame, "pinky")] > 0);
}

TEST_CASE("the radius scale scales the sphere, not the tips") {
  const Anatomy anatomy = infer_anatomy(make_toy_hand());
  const SphereFrame one = compute_sphere_frame(anatomy), half = compute_sphere_frame(anatomy, {.radius_scale = 0.5});
  CHECK(half.radius == doctest::Approx(one.radius / 2));
  CHECK(half.mean_tip_distance == one.mean_tip_distance);
}

TEST_CASE("a left hand has the canonical azimuths of its right twin") {
  const HandModel model = make_toy_hand();
  const SphereFrame right = compute_sphere_frame(infer_anatomy(model));
  const SphereFrame left = compute_sphere_frame(infer_anatomy(mirrored(model)));
  CHECK(left.mirrored);
  CHECK(left.slots == right.slots);
  for (std::size_t i = 0; i < right.open_azimuth.size(); ++i)
    CHECK(left.open_azimuth[i] == doctest::Approx(right.open_azimuth[i]));
}

TEST_CASE("the fingertip in S stands at its open azimuth, one radius above the palm plane") {
  const Anatomy anatomy = infer_anatomy(make_toy_hand({.wrist = true}));
  const SphereFrame frame = compute_sphere_frame(anatomy);
  for (int finger = 0; finger < 5; ++finger) {
    const Vector3d tip = fingertip_in_sphere(anatomy, frame, finger, anatomy.q_open);
    CHECK(std::atan2(tip.y, tip.x) == doctest::Approx(frame.open_azimuth[finger]));
    CHECK(tip.z == doctest::Approx(-frame.radius).epsilon(1e-3));
  }
}

TEST_CASE("without thumb and middle finger, x points along the fingers against the one that stands most apart") {
  // in degrees of azimuth; the gaps on both sides of each add up to 210, 190 and 320
  const double azimuths[] = {0, 40, 190}, forward = 20 * std::numbers::pi / 180;
  ToyModel toy("claw");
  for (const double degrees : azimuths) {
    const double azimuth = degrees * std::numbers::pi / 180;
    ToyFinger finger{
        .name = "finger" + std::to_string(static_cast<int>(degrees)), .closing = {0, 0, 1}, .side_range = 0};
    finger.direction = {std::cos(azimuth), std::sin(azimuth), 0};
    finger.root = 0.03 * finger.direction;
    toy.add_finger(0, finger);
  }
  const HandConfig config =
      parse_hand_config(R"({"thumb": null, "middle_finger": null, "handedness": "none"})", "claw.json");
  const SphereFrame frame = compute_sphere_frame(infer_anatomy(toy.take(), config));
  CHECK(norm(frame.T_palm_sphere.rotation.column(2) - Vector3d{0, 0, 1}) < 1e-3);
  CHECK(norm(frame.T_palm_sphere.rotation.column(0) - Vector3d{std::cos(forward), std::sin(forward), 0}) < 1e-3);
  CHECK(frame.slots[2][4]);
}

TEST_CASE("a hand whose open fingertips meet in the palm centre has no sphere") {
  Anatomy anatomy = infer_anatomy(make_toy_parallel_gripper());
  const Vector3d center = compute_sphere_frame(anatomy).palm_center_palm;
  for (FingerAnatomy& finger : anatomy.fingers) {  // the jaws only slide, along y
    const Joint& slide = anatomy.tree.joints[finger.joints.back()];
    const double q = anatomy.q_open[finger.joints.back()];
    finger.p_tip_link = anatomy.links[finger.tip_link].T_joint_link.inverse() *
                        (center - slide.T_parent_joint.translation - q * slide.axis);
  }
  CHECK_THROWS_WITH_AS(compute_sphere_frame(anatomy),
                       "the open fingertips all lie in the palm centre; check the joint origins of the model", Error);
}

TEST_CASE("hands that the action space has no planes for are refused") {
  CHECK_THROWS_WITH_AS(compute_sphere_frame(infer_anatomy(make_toy_gripper(6))), doctest::Contains("6 fingers"), Error);
}

TEST_CASE("merging the pinky's slot is said to do nothing where there is no pinky") {
  const SphereFrameOptions merged = {.merge_pinky = true};
  CHECK(compute_sphere_frame(infer_anatomy(make_toy_hand()), merged).warnings.empty());
  const SphereFrame four = compute_sphere_frame(infer_anatomy(make_toy_hand({.fingers = 3})), merged);
  REQUIRE(four.warnings.size() == 1);
  CHECK(four.warnings[0].find("on a hand of 4 fingers") != std::string::npos);
  CHECK(four.slots == compute_sphere_frame(infer_anatomy(make_toy_hand({.fingers = 3}))).slots);
}
