#include "uhas/anatomy/opening/palm_normal.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace uhas {
namespace {

/// Closing directions (unit vectors) of a row have a mean at least this long.
constexpr double kRowCoherence = 0.8;
/// A thumb that closes this exactly against two fingers makes a gripper (cosine of 20 degrees).
constexpr double kOpposed = 0.94;

double angle_between(Vector3d a, Vector3d b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

/// Sums over the fingers beside the thumb.
struct RowSums {
  Vector3d closing, axis, direction;
  int count = 0;

  double coherence() const { return norm(closing) / count; }
};

RowSums sum_row(std::span<const FingerPosture> postures, int thumb) {
  RowSums row;
  for (int i = 0; i < static_cast<int>(postures.size()); ++i) {
    if (i == thumb) continue;
    row.closing += postures[i].closing;
    row.axis += postures[i].axis;
    row.direction += postures[i].direction;
    ++row.count;
  }
  return row;
}

/// A row closes one way; one or two fingers that a thumb closes against are none.
bool is_row(const RowSums& row, std::span<const FingerPosture> postures, int thumb) {
  const bool gripper = thumb >= 0 && row.count < 3 && dot(normalized(row.axis), postures[thumb].axis) < -kOpposed;
  return row.coherence() > kRowCoherence && !gripper;
}

PalmNormal normal_of_row(const RowSums& row, std::span<const FingerPosture> postures, int thumb) {
  const Vector3d normal = normalized(row.closing);

  // fingers side by side agree in direction, fingers all around have axes that cancel; else some of them may be a thumb
  const double in_row = norm(row.direction) / row.count, around = 1 - norm(row.axis) / row.count;
  const double coherence = row.coherence() * std::max(in_row * in_row, around * around);

  // the spread of the closing directions about their mean
  double squares = 0;
  for (int i = 0; i < static_cast<int>(postures.size()); ++i)
    if (i != thumb) squares += std::pow(angle_between(postures[i].closing, normal), 2);
  const double spread = std::sqrt(squares / (row.count * std::max(row.count - 1, 1)));
  return {normal, false, coherence, normalized(row.axis), spread};
}

/// Opposing fingers swing through the axis they close around: outward, then along it, then inward. Closing direction
/// and finger direction both have a part along the axis, and their other parts cancel when every side counts once.
/// Axes that do not cancel too are no such fingers, and their sum tells little.
PalmNormal normal_of_opposing(std::span<const FingerPosture> postures) {
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

}  // namespace

PalmNormal find_palm_normal(std::span<const FingerPosture> postures, int thumb) {
  const RowSums row = sum_row(postures, thumb);
  return is_row(row, postures, thumb) ? normal_of_row(row, postures, thumb) : normal_of_opposing(postures);
}

}  // namespace uhas
