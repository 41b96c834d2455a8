#include "uhas/anatomy/palm/normal_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace uhas {
namespace {

/// Standard error of a roll joint's neutral value where zero does not tell it (rad).
constexpr double kGuessedRoll = 0.26;

double square(double x) { return x * x; }

/// How far a finger may be rolled about its own direction (rad, a standard error) by joints whose open value
/// is a guess.
double roll_error(const Flexion& flexion, const FingerPosture& posture, const FingerPose& pose) {
  double rolled = 0;
  for (int i = 0; i < flexion.positions.back(); ++i)
    if (std::ranges::find(flexion.positions, i) == flexion.positions.end())
      rolled = std::max(rolled, std::abs(dot(pose.axis[i], posture.direction)));
  return kGuessedRoll * rolled;
}

/// Squared error of the mean of like estimates: half of what each is off by is common to all, a designer's habit; the
/// other half is its own.
double squared_error_of_mean(const std::vector<double>& errors) {
  const double count = static_cast<double>(errors.size());
  double sum = 0, squares = 0;
  for (double error : errors) sum += error, squares += square(error);
  return (square(sum) + squares) / (2 * square(count));
}

/// Squared angle about the fingers' axes between the palm's surface and the normal that the slab's own error leaves
/// unexplained. Sideways palms are no slabs: a thumb's ball tilts the human one by 12 degrees.
double unexplained_tilt(const PalmNormal& found, const PalmSlab& slab) {
  const double tilt = std::atan(dot(slab.normal, cross(found.axis, found.normal)) / dot(slab.normal, found.normal));
  return std::max(0.0, square(tilt) - square(slab.error));
}

}  // namespace

double palm_normal_error(const Anatomy& anatomy, const PalmNormal& found, const NormalWitnesses& witnesses,
                         std::span<const double> q) {
  std::vector<double> base, roll;
  FingerPose pose;
  for (int i = 0; i < static_cast<int>(witnesses.flexions.size()); ++i) {
    if (i == anatomy.thumb && !found.opposing) continue;
    const Flexion& flexion = witnesses.flexions[i];
    pose_finger(anatomy, anatomy.fingers[i], q, pose);
    base.push_back(flexion.base_error);
    roll.push_back(witnesses.zero_is_straight ? 0 : roll_error(flexion, witnesses.postures[i], pose));
  }
  if (found.opposing) {  // what opposing fingers have in common cancels
    double squares = 0;
    for (double error : base) squares += square(error);
    return std::sqrt(squares) / static_cast<double>(base.size());
  }
  const double surface = witnesses.slab ? unexplained_tilt(found, *witnesses.slab) : 0;
  return std::sqrt(squared_error_of_mean(base) + squared_error_of_mean(roll) + square(found.spread) + surface);
}

}  // namespace uhas
