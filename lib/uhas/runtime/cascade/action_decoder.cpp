#include "uhas/runtime/cascade/action_decoder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace uhas {
namespace {

template <class Real>
bool all_finite(std::span<const Real> numbers) noexcept {
  for (Real number : numbers)
    if (!std::isfinite(number)) return false;
  return true;
}

}  // namespace

void check_convention(const ActionConvention& convention) {
  if (std::abs(convention.azimuth_sign) != 1)
    throw Error(ErrorCode::invalid_option, "", "azimuth_sign is " + std::to_string(convention.azimuth_sign),
                "choose 1 or -1");
  const auto bounded = [](double low, double x, double high) { return x >= low && x <= high; };
  if (!bounded(-kMostRadialBound, convention.radial_lower, 0) || !bounded(0, convention.radial_upper, kMostRadialBound))
    throw Error(ErrorCode::invalid_option, "", "radial_lower or radial_upper is out of range",
                "choose -1e6 <= radial_lower <= 0 <= radial_upper <= 1e6");
}

template <class Real>
ActionDecoder<Real>::ActionDecoder(const HandProfile& profile, const ActionConvention& convention)
    : convention_(convention) {
  for (const ProfileFinger& finger : profile.fingers) {
    Owner owner{};
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (finger.slots[slot]) owner.slots[owner.slot_count++] = slot;
    owner.share = Real(1) / Real(owner.slot_count);
    if (finger.lateral_table >= 0) {
      owner.lower = static_cast<Real>(profile.lateral_tables[finger.lateral_table].delta_theta_lower);
      owner.upper = static_cast<Real>(profile.lateral_tables[finger.lateral_table].delta_theta_upper);
    }
    owners_.push_back(owner);
  }
  for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) {
    std::array<double, kMaxDrivingVectors> phi;
    for (int j = 0; j < vectors; ++j) {
      default_phi_[vectors - 1][j] = std::numbers::pi_v<Real> * Real(j + 1) / Real(vectors + 1);
      phi[j] = std::numbers::pi * (j + 1) / (vectors + 1);
    }
    // two vectors stand where leads look
    for (int u = 0; u < kLeadInputs; ++u)
      for (int j = 0; j < vectors; ++j)
        lead_shares_[vectors - 1][u][j] =
            vectors == kLeadInputs ? Real(u == j)
                                   : static_cast<Real>(displacement_share(kLeadAngles[u], std::span(phi).first(vectors),
                                                                          j, convention.held_toward_pole));
  }
}

template <class Real>
int ActionDecoder<Real>::vectors_of(std::size_t size) noexcept {
  for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors)
    if (size == std::size_t(kSlotCount * (1 + vectors))) return vectors;
  return 0;
}

template <class Real>
Status ActionDecoder<Real>::check(const Action<Real>& action) noexcept {
  const int vectors = vectors_of(action.values.size());
  if (vectors == 0) return Status::wrong_size;
  if (!all_finite(action.values)) return Status::non_finite_input;
  if (const Status status = check_offsets(action.azimuth_offsets); status != Status::ok) return status;
  if (const Status status = check_bounds(action.radial_bounds); status != Status::ok) return status;
  return check_angles(action.driving_vectors_phi, vectors);
}

template <class Real>
Status ActionDecoder<Real>::check_offsets(std::span<const Real> offsets) noexcept {
  if (!offsets.empty() && offsets.size() != kSlotCount) return Status::wrong_size;
  return all_finite(offsets) ? Status::ok : Status::non_finite_input;
}

template <class Real>
Status ActionDecoder<Real>::check_bounds(std::span<const Real> bounds) noexcept {
  if (bounds.empty()) return Status::ok;
  if (bounds.size() != 2) return Status::wrong_size;
  if (!all_finite(bounds)) return Status::non_finite_input;
  constexpr Real most(kMostRadialBound);
  const bool sound = bounds[0] >= -most && bounds[0] <= Real(0) && bounds[1] >= Real(0) && bounds[1] <= most;
  return sound ? Status::ok : Status::invalid_radial_bounds;
}

template <class Real>
Status ActionDecoder<Real>::check_angles(std::span<const Real> phi, int vectors) noexcept {
  if (!phi.empty() && phi.size() != std::size_t(vectors) && phi.size() != std::size_t(kSlotCount * vectors))
    return Status::wrong_size;
  for (std::size_t i = 0; i < phi.size(); ++i) {
    const Real before = i % vectors == 0 ? Real(0) : phi[i - 1];
    if (!(phi[i] > before) || !(phi[i] < std::numbers::pi_v<Real>)) return Status::invalid_driving_vectors;
  }
  return Status::ok;
}

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

template class ActionDecoder<float>;
template class ActionDecoder<double>;

}  // namespace uhas
