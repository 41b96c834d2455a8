#include "uhas/anatomy/opening/open_hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/opening/normal_error.hpp"
#include "uhas/anatomy/opening/open_pose.hpp"
#include "uhas/anatomy/opening/palm_normal.hpp"
#include "uhas/anatomy/opening/thumb_side.hpp"

namespace uhas {
namespace {

/// A palm normal with a standard error of 12 degrees has confidence 0.5: one of five such is off by 15 degrees or more.
constexpr double kDoubtfulError = 12 * std::numbers::pi / 180;
/// From this margin on the side to which a thumb closes is clear; the largest is 2.
constexpr double kClearThumbSide = 0.6;

/// Where the designer put straight fingers at zero, other joints are neutral there too.
ExtendedHand extend_from_zero(const HandSkeleton& hand, const HandMotion& motion, std::vector<double> q) {
  const std::vector<Joint>& joints = hand.tree.joints;
  for (std::size_t i = 0; i < q.size(); ++i)
    if (!motion.held[i] && joints[i].lower <= 0 && joints[i].upper >= 0) q[i] = 0;
  return extend_hand(hand, motion, std::move(q));
}

/// The palm normal, and the hand extended with its side and roll joints open for it.
struct FoundNormal {
  PalmNormal normal;
  ExtendedHand extended;
};

/// The palm normal follows from the open fingers, and the open pose from the normal: a few rounds agree. A stated
/// normal needs none.
FoundNormal agree_on_normal(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                            const std::optional<Vector3d>& stated_normal) {
  // the normal of the extended fingers; where zero is straight, opposing ones are asked with all their joints there
  FoundNormal found{find_palm_normal(extended.postures, thumb), extended};
  if (found.normal.opposing && motion.zero_is_straight) {
    found.extended = extend_from_zero(hand, motion, found.extended.q);
    found.normal = find_palm_normal(found.extended.postures, thumb);
  }
  if (stated_normal) {
    found.normal.normal = *stated_normal;
    return found;
  }

  // side and roll joints open for that normal, the fingers extended anew, and asked again
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> q = find_open_pose(hand, motion, found.extended, thumb, found.normal, Bases::held);
    found.extended = extend_hand(hand, motion, std::move(q));
    found.normal = find_palm_normal(found.extended.postures, thumb);
  }
  return found;
}

/// Three digits after the point.
std::string number_text(double component) {
  const double rounded = std::round(1000 * component) / 1000 + 0.0;  // never -0
  return std::to_string(rounded).substr(0, rounded < 0 ? 6 : 5);
}

HandFinding explain_normal(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& open, int thumb,
                           const PalmNormal& normal, Vector3d normal_root, const HandConfig& config) {
  const std::string item = "palm_normal_in_root";
  const std::string value =
      number_text(normal_root.x) + " " + number_text(normal_root.y) + " " + number_text(normal_root.z);
  if (config.palm_normal_in_root) return {item, value, kStatedInConfig, 1};

  // how well the fingers agree, how surely each knows its closing side, and how far off they may all be
  double evidence = 0;
  for (const Flexion& flexion : motion.flexions)
    evidence += flexion.closing.evidence / static_cast<double>(motion.flexions.size());
  const double error = palm_normal_error(hand, motion, open, thumb, normal) / kDoubtfulError;
  const double confidence = normal.coherence * std::min(1.0, 2 * evidence) / (1 + error * error);
  return {item, value,
          normal.opposing ? "the axis around which opposing fingers close"
                          : "mean direction in which the fingers close, the side of their larger joint ranges",
          confidence};
}

HandFinding explain_open_pose(const HandSkeleton& hand, std::span<const FingerPosture> postures, int thumb,
                              Vector3d normal, double thumb_side_margin, const HandConfig& config) {
  const std::string item = "q_open", value = "fingers extended";
  const auto independent = static_cast<std::size_t>(
      std::ranges::count_if(hand.tree.joints, [](const Joint& joint) { return joint.mimic_master < 0; }));
  if (config.q_open.size() == independent) return {item, value, kStatedInConfig, 1};

  // how exactly the worst of the fingers faces the normal, and how clear the thumb's side is
  double openness = 1;
  for (int i = 0; i < hand.finger_count(); ++i)
    if (i != thumb) openness = std::min(openness, dot(postures[i].closing, normal));
  const double confidence = std::clamp(std::min(openness, thumb_side_margin / kClearThumbSide), 0.0, 1.0);

  std::string reason = "each finger straight in the palm plane with its pad toward the palm normal";
  if (!config.q_open.empty()) reason += "; " + count_joints(config.q_open.size()) + " " + kStatedInConfig;
  return {item, value, reason, confidence};
}

}  // namespace

OpenHand open_hand(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                   const Rotationd& R_root_palm, const HandConfig& config) {
  const auto to_palm = [&](Vector3d v_root) { return R_root_palm.transposed() * v_root; };
  OpenHand open;

  // the normal, the side to which the thumb closes, the open pose
  std::optional<Vector3d> stated_normal;
  if (config.palm_normal_in_root) stated_normal = to_palm(unit_direction(*config.palm_normal_in_root));
  const FoundNormal found = agree_on_normal(hand, motion, extended, thumb, stated_normal);
  const TurnedThumb turned = turn_thumb(hand, motion, found.extended, thumb, found.normal.normal);
  open.q = find_open_pose(hand, turned.motion, turned.extended, thumb, found.normal, Bases::searched);
  open.postures = measure_postures(hand, turned.motion.flexions, open.q);

  // what is kept of the normal is its direction in the root frame, which a config may state
  open.palm_normal_root =
      unit_direction(config.palm_normal_in_root ? *config.palm_normal_in_root : R_root_palm * found.normal.normal);
  open.palm_normal_palm = to_palm(open.palm_normal_root);

  const ExtendedHand opened{open.q, turned.extended.bases, open.postures};
  open.findings = {explain_normal(hand, turned.motion, opened, thumb, found.normal, open.palm_normal_root, config),
                   explain_open_pose(hand, open.postures, thumb, open.palm_normal_palm, turned.margin, config)};
  return open;
}

}  // namespace uhas
