#include "uhas/anatomy/opening/normal_error.hpp"

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
double roll_error(const FlexionJoints& flexion, const FingerPosture& posture, const FingerPose& pose) {
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

double palm_normal_error(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                         const PalmNormal& found) {
  // what each witness may be off by: the angle of its base to the palm, and its roll where zero does not tell that
  std::vector<double> base, roll;
  for (int i = 0; i < hand.finger_count(); ++i) {
    if (i == thumb && !found.opposing) continue;
    const FingerPose pose = pose_finger(hand.tree, hand.fingers[i], extended.q);
    base.push_back(extended.bases[i].error);
    roll.push_back(motion.zero_is_straight ? 0 : roll_error(motion.flexions[i], extended.postures[i], pose));
  }

  // what opposing fingers have in common cancels
  if (found.opposing) {
    double squares = 0;
    for (double error : base) squares += square(error);
    return std::sqrt(squares) / static_cast<double>(base.size());
  }

  // a row: the errors of the means, the spread of its fingers, and what the palm's surface says against it
  const double surface = motion.slab ? unexplained_tilt(found, *motion.slab) : 0;
  return std::sqrt(squared_error_of_mean(base) + squared_error_of_mean(roll) + square(found.spread) + surface);
}

}  // namespace uhas
