#include "uhas/anatomy/digits/thumb.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/anatomy/fingers/finger_names.hpp"

namespace uhas {
namespace {

/// Fingers of a row are at least this alike, and the thumb less so by this much.
constexpr double kRowLikeness = 0.6, kThumbDifference = 0.2;

/// 1 for neighbours in a row: same direction, same closing side, knuckles side by side; down to -1.
double likeness(const FingerPosture& a, const FingerPosture& b, double finger_length) {
  const Vector3d along = normalized(a.direction + b.direction);
  const double stagger = std::abs(dot(a.knuckle - b.knuckle, along)) / finger_length;
  const double side_by_side = 1 - 2 * std::min(1.0, stagger);
  return (dot(a.direction, b.direction) + dot(a.closing, b.closing) + side_by_side) / 3;
}

/// What the other fingers are without `finger`.
struct Candidate {
  int finger = -1;
  double likeness = -1;   ///< -1..1: how alike the others are, in the mean of their pairs
  double difference = 0;  ///< 0..2: how much less they are like this finger
};

Candidate judge_candidate(std::span<const FingerPosture> postures, int finger, double finger_length) {
  const int count = static_cast<int>(postures.size());
  double others = 0, apart = 0;
  for (int i = 0; i < count; ++i) {
    if (i == finger) continue;
    apart += likeness(postures[i], postures[finger], finger_length);
    for (int j = 0; j < i; ++j)
      if (j != finger) others += likeness(postures[i], postures[j], finger_length);
  }
  others /= (count - 1) * (count - 2) / 2.0;
  apart /= count - 1;
  return {finger, others, others - apart};
}

}  // namespace

Thumb find_thumb(const HandSkeleton& hand, std::span<const FingerPosture> postures, const HandConfig& config) {
  if (config.thumb) {
    const int finger = find_named_finger(hand, *config.thumb, config, "thumb");
    return {finger, {"thumb", describe_finger(hand, finger), kStatedInConfig, 1}};
  }

  // the finger without which the others are most alike; of two fingers none is a thumb
  const std::string no_thumb = "no finger stands apart from a row of like fingers";
  if (hand.finger_count() < 3) return {-1, {"thumb", "none", no_thumb, 1}};
  Candidate best;
  for (int finger = 0; finger < hand.finger_count(); ++finger) {
    const Candidate candidate = judge_candidate(postures, finger, mean_finger_length(hand));
    if (candidate.likeness > best.likeness) best = candidate;
  }

  // by how much it is one, counted from where the others are barely alike and it is barely different
  const double margin = std::min((best.likeness - kRowLikeness) / 0.2, (best.difference - kThumbDifference) / 0.3);
  const double confidence = std::min(1.0, 0.4 + std::abs(margin));
  if (margin < 0) return {-1, {"thumb", "none", no_thumb, confidence}};
  return {best.finger,
          {"thumb", describe_finger(hand, best.finger),
           "without it the others are most alike in direction, closing side and place of their knuckles", confidence}};
}

}  // namespace uhas
