#include "uhas/sphere_frame/slots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "uhas/base/spherical.hpp"

namespace uhas {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// Where the fingertips of a right human hand stand: pinky, ring, middle, index, thumb.
constexpr std::array<double, kSlotCount> kCanonicalAzimuth = {40 * kDegree, 20 * kDegree, 0, -20 * kDegree,
                                                              -115 * kDegree};
constexpr double kTie = 5 * kDegree;
constexpr int kThumbSlot = 4;

double angle_between(double a, double b) { return std::abs(wrap_angle(a - b)); }

/// The fingers beside the thumb finger, from the pinky's side on: around the axis, by falling azimuth.
std::vector<int> order_around_axis(std::span<const double> place, int thumb_finger) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(place.size()); ++i)
    if (i != thumb_finger) order.push_back(i);
  const auto turn_from_thumb = [&](int i) {
    const double turn = wrap_angle(place[i] - place[thumb_finger]);
    return turn < 0 ? turn + 2 * std::numbers::pi : turn;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return turn_from_thumb(a) > turn_from_thumb(b); });
  return order;
}

/// Rising slots below the thumb's for the ordered fingers: least total distance to the canonical azimuths; among ties
/// the choice most symmetric about the middle finger, then the lower slots.
std::vector<int> nearest_slots(std::span<const double> azimuth, const std::vector<int>& order) {
  struct Choice {
    std::vector<int> slots;
    double distance = 0, asymmetry = 0;
  };

  // every set of slots below the thumb's that has one for each finger
  std::vector<Choice> choices;
  for (unsigned set = 0; set < (1u << kThumbSlot); ++set) {
    Choice choice;
    double balance = 0;
    for (int slot = 0; slot < kThumbSlot; ++slot) {
      if ((set >> slot & 1u) == 0) continue;
      choice.slots.push_back(slot);
      balance += kCanonicalAzimuth[slot];
    }
    if (choice.slots.size() != order.size()) continue;
    choice.asymmetry = std::abs(balance);
    for (std::size_t i = 0; i < order.size(); ++i)
      choice.distance += angle_between(azimuth[order[i]], kCanonicalAzimuth[choice.slots[i]]);
    choices.push_back(std::move(choice));
  }

  // the nearest of them; those within a tie of it are as good, and the most symmetric of these is taken
  double least = std::numeric_limits<double>::infinity();
  for (const Choice& choice : choices) least = std::min(least, choice.distance);
  std::erase_if(choices, [&](const Choice& choice) { return choice.distance >= least + kTie; });
  return std::min_element(choices.begin(), choices.end(),
                          [](const Choice& a, const Choice& b) {
                            if (std::abs(a.asymmetry - b.asymmetry) > 1e-9) return a.asymmetry < b.asymmetry;
                            return a.slots < b.slots;
                          })
      ->slots;
}

/// The finger whose azimuth is nearest to that of a free slot; of equals the one with the lower slot.
int nearest_owner(std::span<const double> azimuth, const std::vector<int>& slot_of_finger, int free_slot) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (double angle : azimuth) least = std::min(least, angle_between(angle, kCanonicalAzimuth[free_slot]));
  for (int i = 0; i < static_cast<int>(azimuth.size()); ++i) {
    if (angle_between(azimuth[i], kCanonicalAzimuth[free_slot]) >= least + kTie) continue;
    if (best < 0 || slot_of_finger[i] < slot_of_finger[best]) best = i;
  }
  return best;
}

}  // namespace

SlotAssignment assign_slots(std::span<const double> azimuth, std::span<const double> place, int thumb_finger,
                            bool has_thumb, bool merge_pinky) {
  // one slot for each finger: the thumb's for the thumb, the others in their order around the axis
  const int count = static_cast<int>(azimuth.size());
  const std::vector<int> order = order_around_axis(place, thumb_finger);
  const bool ring_is_last = count == 4 && has_thumb;  // such hands lack the pinky, wherever their fingers stand
  const std::vector<int> chosen = ring_is_last ? std::vector<int>{1, 2, 3} : nearest_slots(azimuth, order);
  std::vector<int> slot_of_finger(azimuth.size(), kThumbSlot);
  for (std::size_t i = 0; i < order.size(); ++i) slot_of_finger[order[i]] = chosen[i];

  // free slots go to a neighbour, so that no input is dead
  SlotAssignment result;
  result.slots.resize(azimuth.size());
  for (int slot = 0; slot < kSlotCount; ++slot) {
    const auto owner = std::find(slot_of_finger.begin(), slot_of_finger.end(), slot);
    int finger = static_cast<int>(owner - slot_of_finger.begin());
    if (owner == slot_of_finger.end())
      finger = ring_is_last ? order.front() : nearest_owner(azimuth, slot_of_finger, slot);
    result.slots[finger][slot] = true;
  }

  // on request, ring and pinky of five fingers own both of their slots
  if (count == kSlotCount && merge_pinky)
    for (int finger : {order[0], order[1]}) result.slots[finger][0] = result.slots[finger][1] = true;

  // digits have names on a hand that has most of them; else fingers are counted in the order of their slots
  result.own_slot = slot_of_finger;
  constexpr std::array<const char*, kSlotCount> digits = {"pinky", "ring", "middle", "index", "thumb"};
  for (int i = 0; i < count; ++i) {
    const auto before =
        std::count_if(slot_of_finger.begin(), slot_of_finger.end(), [&](int slot) { return slot < slot_of_finger[i]; });
    result.names.push_back(has_thumb && count >= 4 ? digits[slot_of_finger[i]] : "finger" + std::to_string(before + 1));
  }
  return result;
}

}  // namespace uhas
