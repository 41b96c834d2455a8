#include "uhas/anatomy/fingers/digits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace uhas {
namespace {

/// Fingers of a row are at least this alike, and the thumb less so by this much.
constexpr double kRowLikeness = 0.6, kThumbDifference = 0.2;
/// Closing directions (unit vectors) of a row have a mean at least this long.
constexpr double kRowCoherence = 0.8;
/// A thumb that closes this exactly against two fingers makes a gripper (cosine of 20 degrees).
constexpr double kOpposed = 0.94;

double angle_between(Vector3d a, Vector3d b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

/// 1 for neighbours in a row: same direction, same closing side, knuckles side by side; down to -1.
double likeness(const FingerPosture& a, const FingerPosture& b, double finger_length) {
  const Vector3d along = normalized(a.direction + b.direction);
  const double stagger = std::abs(dot(a.knuckle - b.knuckle, along)) / finger_length;
  const double side_by_side = 1 - 2 * std::min(1.0, stagger);
  return (dot(a.direction, b.direction) + dot(a.closing, b.closing) + side_by_side) / 3;
}

}  // namespace

Thumb find_thumb(std::span<const FingerPosture> postures, double finger_length) {
  const int count = static_cast<int>(postures.size());
  Thumb thumb;
  if (count < 3) return thumb;
  double second = -1;
  thumb.likeness = -1;
  for (int candidate = 0; candidate < count; ++candidate) {
    double others = 0, apart = 0;
    for (int i = 0; i < count; ++i) {
      if (i == candidate) continue;
      apart += likeness(postures[i], postures[candidate], finger_length);
      for (int j = 0; j < i; ++j)
        if (j != candidate) others += likeness(postures[i], postures[j], finger_length);
    }
    others /= (count - 1) * (count - 2) / 2.0;
    apart /= count - 1;
    if (others > thumb.likeness) {
      second = thumb.likeness;
      thumb.finger = candidate;
      thumb.likeness = others;
      thumb.difference = others - apart;
    } else {
      second = std::max(second, others);
    }
  }
  const double margin = std::min((thumb.likeness - kRowLikeness) / 0.2, (thumb.difference - kThumbDifference) / 0.3);
  thumb.confidence = std::min(1.0, 0.4 + std::abs(margin));
  if (margin < 0) thumb.finger = -1;
  return thumb;
}

PalmNormal find_palm_normal(std::span<const FingerPosture> postures, int thumb) {
  Vector3d closing, axis, direction;
  int count = 0;
  for (int i = 0; i < static_cast<int>(postures.size()); ++i) {
    if (i == thumb) continue;
    closing += postures[i].closing;
    axis += postures[i].axis;
    direction += postures[i].direction;
    ++count;
  }
  const double coherence = norm(closing) / count;
  const bool gripper = thumb >= 0 && count < 3 && dot(normalized(axis), postures[thumb].axis) < -kOpposed;
  if (coherence > kRowCoherence && !gripper) {
    // Fingers side by side agree in direction, fingers all around have axes that cancel; else some of them may
    // be a thumb.
    const double in_row = norm(direction) / count, around = 1 - norm(axis) / count;
    const Vector3d normal = normalized(closing);
    double squares = 0;
    for (int i = 0; i < static_cast<int>(postures.size()); ++i)
      if (i != thumb) squares += std::pow(angle_between(postures[i].closing, normal), 2);
    return {normal, false, coherence * std::max(in_row * in_row, around * around), normalized(axis),
            std::sqrt(squares / (count * std::max(count - 1, 1)))};
  }

  // Opposing fingers swing through the axis they close around: outward, then along it, then inward. Closing direction
  // and finger direction both have a part along the axis, and their other parts cancel when every side counts once.
  // Axes that do not cancel too are no such fingers, and their sum tells little.
  Vector3d sum, axes;
  double weights = 0;
  for (const FingerPosture& posture : postures) {
    double same_side = 0;
    for (const FingerPosture& other : postures) same_side += std::max(0.0, dot(posture.axis, other.axis));
    sum += (posture.closing + posture.direction) / same_side;
    axes += posture.axis / same_side;
    weights += 1 / same_side;
  }
  return {normalized(sum), true, std::min(1.0, norm(sum) / weights) * (1 - norm(axes) / weights), {}, 0};
}

int find_middle_finger(std::span<const FingerPosture> postures, int thumb, Vector3d normal) {
  const int count = static_cast<int>(postures.size());
  if (thumb < 0 || count < 4 || count > 5) return -1;
  Vector3d forward;
  std::vector<int> row;
  for (int i = 0; i < count; ++i) {
    if (i == thumb) continue;
    forward += postures[i].direction;
    row.push_back(i);
  }
  const Vector3d across = normalized(cross(normal, forward));
  const auto place = [&](int i) { return dot(postures[i].root + postures[i].tip, across) / 2; };
  double center = 0;
  for (int i : row) center += place(i) / static_cast<double>(row.size());
  const double thumb_side = place(thumb) < center ? -1 : 1;
  std::sort(row.begin(), row.end(), [&](int a, int b) { return thumb_side * place(a) > thumb_side * place(b); });
  return row[1];
}

}  // namespace uhas
