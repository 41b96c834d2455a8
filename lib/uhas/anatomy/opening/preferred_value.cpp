#include "uhas/anatomy/opening/preferred_value.hpp"

#include <algorithm>
#include <array>

#include "uhas/anatomy/fingers/finger_pose.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {

double preferred_value(const Joint& joint, double tolerance, bool zero_is_neutral,
                       const std::function<double(double)>& objective) {
  // the best of evenly spread samples
  constexpr int samples = 24;
  const auto at = [&](int i) {  // the ends exactly, whatever rounding makes of the steps
    return i == samples ? joint.upper : joint.lower + (joint.upper - joint.lower) * i / samples;
  };
  int best = 0;
  std::array<double, samples + 1> value;
  for (int i = 0; i <= samples; ++i) {
    value[i] = objective(at(i));
    if (value[i] > value[best]) best = i;
  }

  // golden-section search between its neighbours
  double a = at(std::max(best - 1, 0)), b = at(std::min(best + 1, samples));
  constexpr double ratio = 0.6180339887498949;
  double x1 = b - ratio * (b - a), x2 = a + ratio * (b - a), f1 = objective(x1), f2 = objective(x2);
  for (int i = 0; i < 25; ++i) {
    if (f1 > f2) {
      b = x2, x2 = x1, f2 = f1;
      x1 = b - ratio * (b - a), f1 = objective(x1);
    } else {
      a = x1, x1 = x2, f1 = f2;
      x2 = a + ratio * (b - a), f2 = objective(x2);
    }
  }
  double optimum = f1 > f2 ? x1 : x2, maximum = std::max(f1, f2);
  if (value[best] >= maximum) optimum = at(best), maximum = value[best];

  // among what does as well: zero, then the middle of the range, then the best value
  const double middle = mid_range(joint);
  const bool zero_in_range = joint.lower <= 0 && joint.upper >= 0;
  if (zero_is_neutral && zero_in_range && objective(0) >= maximum - tolerance) return 0;
  return objective(middle) >= maximum - tolerance ? middle : clamp_to_limits(joint, optimum);
}

}  // namespace uhas
