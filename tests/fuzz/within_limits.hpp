// What holds for every solution.
#pragma once

#include <cmath>
#include <span>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

/// Independent joints are within their limits, followers where their masters put them, or at least somewhere.
template <class Real>
bool within_limits(const HandProfile& profile, std::span<const Real> q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = profile.tree.joints[i];
    if (!std::isfinite(q[i])) return false;
    if (joint.mimic_master < 0 && !(q[i] >= static_cast<Real>(joint.lower) && q[i] <= static_cast<Real>(joint.upper)))
      return false;
  }
  return true;
}

}  // namespace uhas::test
