#include "uhas/anatomy/digits/digits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/fingers/finger_names.hpp"
#include "uhas/anatomy/palm_plane.hpp"

namespace uhas {
namespace {

/// A thumb whose root and tip are within 20 degrees of straight ahead or straight against the fingers makes neither a
/// right nor a left hand.
constexpr double kHandedAzimuth = 20 * std::numbers::pi / 180;

/// How far an azimuth is from straight ahead and from straight back (rad).
double angle_aside(double azimuth) { return std::min(std::abs(azimuth), std::numbers::pi - std::abs(azimuth)); }

double root_azimuth(const PalmPlane& plane, int finger) {
  const Vector3d p = plane.roots[finger] - plane.center;
  return std::atan2(dot(p, plane.y), dot(p, plane.x));
}

const char* name_of(Handedness handedness) {
  constexpr const char* names[] = {"none", "right", "left"};
  return names[static_cast<int>(handedness)];
}

struct MiddleFinger {
  int finger = -1;
  HandFinding finding;
};

MiddleFinger choose_middle_finger(const HandSkeleton& hand, const OpenHand& open, int thumb, const HandConfig& config) {
  const std::string item = "middle_finger";
  if (!config.middle_finger) {
    const int finger = find_middle_finger(open.postures, thumb, open.palm_normal_palm);
    return {finger,
            {item, describe_finger(hand, finger),
             finger < 0 ? "a hand without a thumb, or with too few fingers beside it"
                        : "second from the thumb across the palm",
             1}};
  }
  const int finger = find_named_finger(hand, *config.middle_finger, config, item);
  if (finger >= 0 && finger == thumb)
    refuse_config(config, item, describe_finger(hand, thumb) + " is the thumb",
                  "name another finger, or set \"thumb\"");
  return {finger, {item, describe_finger(hand, finger), kStatedInConfig, 1}};
}

struct Hand {
  Handedness handedness = Handedness::none;
  HandFinding finding;
};

/// The open thumb of a right hand stands clockwise of the fingers, seen against the palm normal.
Hand choose_handedness(const OpenHand& open, int thumb, int middle, const HandConfig& config) {
  const std::string item = "handedness";
  if (config.handedness) return {*config.handedness, {item, name_of(*config.handedness), kStatedInConfig, 1}};
  if (thumb < 0) return {Handedness::none, {item, name_of(Handedness::none), "no thumb", 1}};

  // aside of the fingers' line by its tip or by its root
  std::vector<Vector3d> roots, tips;
  for (const FingerPosture& posture : open.postures) roots.push_back(posture.root), tips.push_back(posture.tip);
  const PalmPlane plane = measure_palm_plane(roots, tips, open.palm_normal_palm, thumb, middle);
  const double azimuth = plane.azimuth[thumb];
  const double aside = std::max(angle_aside(azimuth), angle_aside(root_azimuth(plane, thumb)));
  const double confidence = std::min(1.0, 0.5 + std::abs(aside - kHandedAzimuth) / (2 * kHandedAzimuth));
  if (aside < kHandedAzimuth)
    return {Handedness::none,
            {item, name_of(Handedness::none), "the thumb stands straight against the fingers", confidence}};
  const Handedness handedness = azimuth < 0 ? Handedness::right : Handedness::left;
  return {handedness,
          {item, name_of(handedness), "the side of the middle finger on which the open thumb stands", confidence}};
}

}  // namespace

Digits name_digits(const HandSkeleton& hand, const OpenHand& open, int thumb, const HandConfig& config) {
  const MiddleFinger middle = choose_middle_finger(hand, open, thumb, config);
  const Hand side = choose_handedness(open, thumb, middle.finger, config);
  return {middle.finger, side.handedness, {middle.finding, side.finding}};
}

int find_middle_finger(std::span<const FingerPosture> postures, int thumb, Vector3d palm_normal) {
  const int count = static_cast<int>(postures.size());
  if (thumb < 0 || count < 4 || count > 5) return -1;

  // the fingers beside the thumb
  Vector3d forward;
  std::vector<int> row;
  for (int i = 0; i < count; ++i) {
    if (i == thumb) continue;
    forward += postures[i].direction;
    row.push_back(i);
  }

  // their places across the palm, from the thumb's side on
  const Vector3d across = normalized(cross(palm_normal, forward));
  const auto place = [&](int i) { return dot(postures[i].root + postures[i].tip, across) / 2; };
  double center = 0;
  for (int i : row) center += place(i) / static_cast<double>(row.size());
  const double thumb_side = place(thumb) < center ? -1 : 1;
  std::sort(row.begin(), row.end(), [&](int a, int b) { return thumb_side * place(a) > thumb_side * place(b); });
  return row[1];
}

}  // namespace uhas
