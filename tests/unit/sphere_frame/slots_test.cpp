#include "uhas/sphere_frame/slots.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace uhas;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Azimuths in degrees; the last finger stands in the thumb's place.
std::vector<std::string> slots(std::vector<double> azimuth, bool has_thumb, bool merge_pinky = false) {
  for (double& angle : azimuth) angle *= kDegree;
  const SlotAssignment result =
      assign_slots(azimuth, azimuth, static_cast<int>(azimuth.size()) - 1, has_thumb, merge_pinky);
  std::vector<std::string> text;
  for (std::size_t i = 0; i < azimuth.size(); ++i) {
    text.push_back(result.names[i] + ":");
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (result.slots[i][slot]) text.back() += " " + std::to_string(slot);
  }
  return text;
}

using Text = std::vector<std::string>;

}  // namespace

TEST_CASE("five fingers own a slot each, by azimuth") {
  CHECK(slots({-18, 25, -3, 10, -90}, true) == Text{"index: 3", "pinky: 0", "middle: 2", "ring: 1", "thumb: 4"});
  CHECK(slots({-18, 25, -3, 10, -90}, true, true) ==
        Text{"index: 3", "pinky: 0 1", "middle: 2", "ring: 0 1", "thumb: 4"});
}

TEST_CASE("of four fingers with a thumb the ring finger owns two slots, wherever it stands") {
  CHECK(slots({-18, 2, 21, -114}, true) == Text{"index: 3", "middle: 2", "ring: 0 1", "thumb: 4"});
  CHECK(slots({-30, -10, 0, -114}, true) == Text{"index: 3", "middle: 2", "ring: 0 1", "thumb: 4"});
}

TEST_CASE("without a thumb, four fingers take the nearest slots") {
  CHECK(slots({90, 0, -90, 180}, false) == Text{"finger1: 0", "finger2: 1 2", "finger3: 3", "finger4: 4"});
}

TEST_CASE("three fingers: the symmetric choice among ties, free slots to the nearest") {
  CHECK(slots({9, -9, 180}, true) == Text{"finger1: 0 1 2", "finger2: 3", "finger3: 4"});
  CHECK(slots({60, -60, 180}, false) == Text{"finger1: 0 1 2", "finger2: 3", "finger3: 4"});
}

TEST_CASE("two fingers: one in the thumb's place, the other owns the rest") {
  CHECK(slots({0, 180}, false) == Text{"finger1: 0 1 2 3", "finger2: 4"});
}

TEST_CASE("fingers keep their order across the palm where fingertips cross") {
  constexpr double azimuth[] = {-3 * kDegree, 0, 2 * kDegree, -1 * kDegree, -90 * kDegree};
  constexpr double place[] = {-40 * kDegree, -10 * kDegree, 20 * kDegree, 50 * kDegree, -90 * kDegree};
  CHECK(assign_slots(azimuth, place, 4, true, false).own_slot == std::vector<int>{3, 2, 1, 0, 4});
}
