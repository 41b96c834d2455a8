#include "uhas/runtime/action_bounds.hpp"

#include <algorithm>
#include <string>

#include "uhas/base/errors.hpp"
#include "uhas/runtime/cascade/action_decoder.hpp"

namespace uhas {

ActionBounds action_bounds(const HandProfile& profile, int driving_vectors, const ActionConvention& convention) {
  if (driving_vectors < 1 || driving_vectors > kMaxDrivingVectors)
    throw Error(ErrorCode::invalid_option, "", "driving_vectors is " + std::to_string(driving_vectors),
                "choose a number from 1 to 4");
  check_convention(convention);
  validate_profile(profile, "");

  const std::size_t numbers = kSlotCount * (1 + driving_vectors);
  ActionBounds bounds{std::vector<double>(numbers), std::vector<double>(numbers)};
  for (const ProfileFinger& finger : profile.fingers)
    for (int slot = 0; slot < kSlotCount; ++slot) {
      if (!finger.slots[slot]) continue;
      const auto first = kSlotCount + driving_vectors * slot;
      std::fill_n(bounds.lower.begin() + first, driving_vectors, convention.radial_lower);
      std::fill_n(bounds.upper.begin() + first, driving_vectors, convention.radial_upper);
      if (finger.lateral_table < 0) continue;
      const LateralTable& table = profile.lateral_tables[finger.lateral_table];
      const auto [lower, upper] = std::minmax(
          {convention.azimuth_sign * table.delta_theta_lower, convention.azimuth_sign * table.delta_theta_upper});
      bounds.lower[slot] = lower, bounds.upper[slot] = upper;
    }
  return bounds;
}

}  // namespace uhas
