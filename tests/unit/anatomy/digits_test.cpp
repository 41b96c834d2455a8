#include "uhas/anatomy/digits/digits.hpp"

#include <doctest/doctest.h>

#include "postures.hpp"
#include "uhas/anatomy/digits/thumb.hpp"
#include "uhas/base/errors.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// A hand of fingers 0.1 long with one joint each, `j0` and so on.
HandSkeleton hand_of(std::size_t fingers) {
  HandSkeleton hand;
  for (std::size_t i = 0; i < fingers; ++i) {
    hand.tree.joints.emplace_back().name = "j" + std::to_string(i);
    hand.fingers.push_back({{static_cast<int>(i)}, {0, 0, 0.1}});
  }
  return hand;
}

Thumb thumb_of(const std::vector<FingerPosture>& postures, const HandConfig& config = {}) {
  return find_thumb(hand_of(postures.size()), postures, config);
}

Digits digits_of(const std::vector<FingerPosture>& postures, int thumb, const HandConfig& config = {}) {
  OpenHand open;
  open.palm_normal_palm = {1, 0, 0};
  open.postures = postures;
  return name_digits(hand_of(postures.size()), open, thumb, config);
}

}  // namespace

TEST_CASE("the thumb is the finger without which the others are most alike") {
  const Thumb thumb = thumb_of(make_postures_of_hand(4));
  CHECK(thumb.finger == 4);
  CHECK(thumb.finding.value == "j4 .. j4");
  CHECK(thumb.finding.confidence == 1);
}

TEST_CASE("fingers that are all alike have no thumb, nor have two") {
  std::vector<FingerPosture> postures = make_postures_of_hand(4);
  postures.pop_back();
  const Thumb none = thumb_of(postures);
  CHECK(none.finger == -1);
  CHECK(none.finding.value == "none");
  CHECK(none.finding.reason == "no finger stands apart from a row of like fingers");
  CHECK(thumb_of(make_postures_of_hand(1)).finger == -1);
}

TEST_CASE("a config names the thumb") {
  HandConfig config;
  config.thumb = "j1";
  CHECK(thumb_of(make_postures_of_hand(4), config).finger == 1);
  config.thumb = "";
  CHECK(thumb_of(make_postures_of_hand(4), config).finger == -1);
}

TEST_CASE("the middle finger is the second from the thumb, of three or four") {
  const Vector3d normal{1, 0, 0};
  CHECK(find_middle_finger(make_postures_of_hand(4), 4, normal) == 1);
  CHECK(find_middle_finger(make_postures_of_hand(3), 3, normal) == 1);
  CHECK(find_middle_finger(make_postures_of_hand(2), 2, normal) == -1);
  CHECK(find_middle_finger(make_postures_of_hand(4), -1, normal) == -1);
}

TEST_CASE("the side on which the thumb stands makes a right or a left hand") {
  const Digits right = digits_of(make_postures_of_hand(4), 4);
  CHECK(right.middle == 1);
  CHECK(right.handedness == Handedness::right);
  REQUIRE(right.findings.size() == 2);
  CHECK(right.findings[0].item == "middle_finger");
  CHECK(right.findings[1].item == "handedness");
  CHECK(right.findings[1].confidence == 1);

  std::vector<FingerPosture> mirrored;
  for (FingerPosture posture : make_postures_of_hand(4)) {
    for (Vector3d* v : {&posture.root, &posture.tip, &posture.knuckle, &posture.direction}) v->y = -v->y;
    mirrored.push_back(posture);
  }
  CHECK(digits_of(mirrored, 4).handedness == Handedness::left);
}

TEST_CASE("a thumb straight against the fingers makes neither") {
  std::vector<FingerPosture> postures = make_postures_of_hand(3);
  postures.back() = make_posture({0, -0.02, 0}, {0, 0, -1}, {1, 0, 0});
  const Digits digits = digits_of(postures, 3);
  CHECK(digits.handedness == Handedness::none);
  CHECK(digits.findings[1].reason == "the thumb stands straight against the fingers");
  CHECK(digits_of(postures, -1).findings[1].reason == "no thumb");
}

TEST_CASE("a config names the middle finger and the handedness; a thumb is no middle finger") {
  HandConfig config;
  config.middle_finger = "j2";
  config.handedness = Handedness::left;
  const Digits digits = digits_of(make_postures_of_hand(4), 4, config);
  CHECK(digits.middle == 2);
  CHECK(digits.handedness == Handedness::left);
  config.middle_finger = "j4";
  CHECK_THROWS_WITH_AS(digits_of(make_postures_of_hand(4), 4, config), doctest::Contains("is the thumb"), Error);
}
