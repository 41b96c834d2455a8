// What a policy may put out, good and bad, and the many ways in which its actions may be meant. Seeded.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "uhas/runtime/sphere_controller.hpp"

namespace uhas::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}
inline bool happens(Random& random, double probability) { return uniform(random, 0, 1) < probability; }
inline int choose(Random& random, int lower, int upper) {
  return std::uniform_int_distribution<int>(lower, upper)(random);
}

/// How a policy's actions are read and obeyed, over an episode.
template <class Real>
struct PolicySetting {
  SphereControllerOptions controller;
  int vectors = 2;  // V
  bool normalized = false;
  std::vector<Real> phi, offsets, bounds;  // domain randomisation; empty = none

  PolicySetting(Random& random, const SolveOptions& solve)
      : controller{.velocity_scale = std::pow(10, uniform(random, -1, 3)),
                   .range_scale = happens(random, 0.5) ? 1 : uniform(random, 0.5, 1),
                   .time_constant = happens(random, 0.5) ? 0 : uniform(random, 0, 0.3),
                   .solve = solve},
        vectors(choose(random, 1, kMaxDrivingVectors)),
        normalized(happens(random, 0.5)) {
    if (happens(random, 0.5)) {  // one set of driving angles or one a slot, 15 degrees about the usual ones, in order
      const int planes = happens(random, 0.5) ? 1 : kSlotCount;
      const double step = std::numbers::pi / (vectors + 1), most = std::min(std::numbers::pi / 12, 0.4 * step);
      for (int k = 0; k < planes * vectors; ++k)
        phi.push_back(static_cast<Real>(step * (k % vectors + 1) + uniform(random, -most, most)));
    }
    if (happens(random, 0.3))
      for (int slot = 0; slot < kSlotCount; ++slot) offsets.push_back(static_cast<Real>(uniform(random, -0.3, 0.3)));
    if (happens(random, 0.3))
      for (double sign : {-1.0, 1.0}) bounds.push_back(static_cast<Real>(sign * std::pow(10, uniform(random, -2, 1))));
  }

  Action<Real> action(std::span<const Real> values) const { return {values, phi, normalized, offsets, bounds}; }
};

/// A random walk about zero, as of a policy that explores; now and then saturated, or of any size at all.
class RandomPolicy {
 public:
  /// @param size  of an action, 5 + 5 V
  explicit RandomPolicy(int size) : mean_(static_cast<std::size_t>(size)) {}

  /// The next action, in place of `values`.
  template <class Real>
  void act(Random& random, std::vector<Real>& values) {
    std::normal_distribution<double> step(0, 0.2);
    for (double& x : mean_) x = 0.98 * x + step(random);
    values.assign(mean_.begin(), mean_.end());
    const double kind = uniform(random, 0, 1);
    constexpr int most = std::numeric_limits<Real>::max_exponent10 - 2;
    if (kind < 0.05)
      for (Real& value : values) value = std::copysign(Real(kind < 0.025 ? 1 : 2), value);  // the ends of either form
    else if (kind < 0.08)
      for (Real& value : values) value *= static_cast<Real>(std::pow(10.0, choose(random, -most, most)));
  }

 private:
  std::vector<double> mean_;
};

/// One of the numbers becomes NaN or infinite.
template <class Real>
void poison(Random& random, std::vector<Real>& values) {
  constexpr Real bad[] = {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(),
                          -std::numeric_limits<Real>::infinity()};
  values[static_cast<std::size_t>(choose(random, 0, static_cast<int>(values.size()) - 1))] = bad[choose(random, 0, 2)];
}

}  // namespace uhas::test
