// The straight way from the undeformed sphere to an action, in the numbers of the action.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "uhas/runtime/action.hpp"

namespace uhas {

class ActionWay {
 public:
  ActionWay(const HandProfile& profile, const ActionConvention& convention) : convention_(convention) {
    for (const ProfileFinger& finger : profile.fingers) {
      if (finger.lateral_table < 0) continue;
      const LateralTable& table = profile.lateral_tables[finger.lateral_table];
      Range range{table.delta_theta_lower, table.delta_theta_upper};
      if (convention.azimuth_sign < 0) range = {-range.upper, -range.lower};
      for (int slot = 0; slot < kSlotCount; ++slot)
        if (finger.slots[slot]) delta_theta_[slot] = range;
    }
  }

  /// Sets the way's end, held within the bounds of its numbers: beyond them nothing moves. `action` is one that can be
  /// solved, and stays alive as long as `at` is called.
  void lead_to(const Action<double>& action) {
    action_ = action;
    const bool own_bounds = !action.radial_bounds.empty();
    const Range radial{own_bounds ? action.radial_bounds[0] : convention_.radial_lower,
                       own_bounds ? action.radial_bounds[1] : convention_.radial_upper};
    double resting_radial = 0;  // the input that leaves the sphere as it is, or comes nearest to that
    if (convention_.absolute_radii) resting_radial = std::min(1.0, radial.upper);
    if (convention_.absolute_radii && action.normalized && radial.upper > 0) resting_radial /= radial.upper;

    begin_.assign(action.values.size(), resting_radial);
    std::fill_n(begin_.begin(), kSlotCount, 0.0);
    end_.assign(action.values.begin(), action.values.end());
    for (std::size_t i = 0; i < end_.size(); ++i) {
      const Range range = action.normalized ? Range{-1, 1} : i < kSlotCount ? delta_theta_[i] : radial;
      end_[i] = std::clamp(end_[i], range.lower, range.upper);
    }
  }

  /// The action at `scale`: 0 = the undeformed sphere, 1 = the end. Valid until the next call.
  Action<double> at(double scale) {
    values_.resize(end_.size());
    for (std::size_t i = 0; i < end_.size(); ++i) values_[i] = begin_[i] + scale * (end_[i] - begin_[i]);
    Action<double> result = action_;
    result.values = values_;
    return result;
  }

 private:
  struct Range {
    double lower = 0, upper = 0;
  };

  ActionConvention convention_;
  std::array<Range, kSlotCount> delta_theta_{};  // of the input
  Action<double> action_;
  std::vector<double> begin_, end_, values_;
};

}  // namespace uhas
