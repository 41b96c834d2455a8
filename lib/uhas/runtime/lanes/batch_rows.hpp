// A batch as rows: whether its parts fit together, and where each row's numbers are.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/cascade/action_decoder.hpp"

namespace uhas {

/// The actions of one call and where its results go. An action's optional numbers are the same for all rows or each
/// row's own; which of the two, the sizes decide, and for driving angles the batch itself.
template <class Real>
class BatchRows {
 public:
  /// @param widest  numbers of an output row
  /// Returns wrong_size where the sizes do not agree, else ok.
  Status set(const ActionBatch<Real>& batch, std::span<Real> q, std::size_t q_stride, std::span<Status> statuses,
             std::size_t widest) noexcept {
    batch_ = batch;
    q_ = q;
    statuses_ = statuses;
    if (batch_.driving_vectors < 1 || batch_.driving_vectors > kMaxDrivingVectors) return Status::wrong_size;
    if (batch_.stride == 0) batch_.stride = numbers();
    q_stride_ = q_stride == 0 ? widest : q_stride;
    if (const Status status = check_sizes(widest); status != Status::ok) return status;
    shared_ = check_shared();
    return shared_ == Status::wrong_size ? shared_ : Status::ok;
  }

  std::size_t count() const noexcept { return batch_.count; }
  int vectors() const noexcept { return batch_.driving_vectors; }
  int angles() const noexcept { return angles_; }  ///< of a row: 0, V or 5 V
  bool have_common_angles() const noexcept { return !batch_.phi_per_row; }
  bool are_normalized() const noexcept { return batch_.normalized; }

  int hand(std::size_t row) const noexcept { return batch_.hands.empty() ? 0 : batch_.hands[row]; }
  Real* q(std::size_t row) const noexcept { return q_.data() + row * q_stride_; }

  Action<Real> action(std::size_t row) const noexcept {
    return {.values = values(row),
            .driving_vectors_phi = batch_.phi_per_row ? own_angles(row) : batch_.driving_vectors_phi,
            .normalized = batch_.normalized,
            .azimuth_offsets = offsets_per_row_ ? own_offsets(row) : batch_.azimuth_offsets,
            .radial_bounds = bounds_per_row_ ? own_bounds(row) : batch_.radial_bounds};
  }

  /// What the row is refused for, and a note of it in the statuses. What all rows share has been checked once.
  Status judge(std::size_t row, int hand_count) const noexcept {
    Status status = Status::unknown_hand;
    if (hand(row) >= 0 && hand(row) < hand_count)
      status = ActionDecoder<Real>::check({.values = values(row),
                                           .driving_vectors_phi = own_angles(row),
                                           .azimuth_offsets = own_offsets(row),
                                           .radial_bounds = own_bounds(row)});
    if (status == Status::ok) status = shared_;
    if (!statuses_.empty()) statuses_[row] = status;
    return status;
  }

 private:
  std::size_t numbers() const noexcept { return kSlotCount * (1 + batch_.driving_vectors); }

  std::span<const Real> values(std::size_t row) const noexcept {
    return batch_.values.subspan(row * batch_.stride, numbers());
  }

  // what is the row's own; empty where all rows share it
  std::span<const Real> own_angles(std::size_t row) const noexcept {
    return part(batch_.driving_vectors_phi, row, batch_.phi_per_row ? angles_ : 0);
  }
  std::span<const Real> own_offsets(std::size_t row) const noexcept {
    return part(batch_.azimuth_offsets, row, offsets_per_row_ ? kSlotCount : 0);
  }
  std::span<const Real> own_bounds(std::size_t row) const noexcept {
    return part(batch_.radial_bounds, row, bounds_per_row_ ? 2 : 0);
  }
  static std::span<const Real> part(std::span<const Real> numbers, std::size_t row, std::size_t width) noexcept {
    return numbers.subspan(row * width, width);
  }

  Status check_sizes(std::size_t widest) noexcept {
    const std::size_t count = batch_.count, vectors = batch_.driving_vectors;

    // rows of actions and of results; the last one's padding may be missing. That the last row of a mixed set may be of
    // a hand with few joints is not looked at
    const auto holds = [&](std::size_t size, std::size_t stride, std::size_t width) {
      return count == 0 || (stride >= width && size >= width && (size - width) / stride >= count - 1);
    };
    if (!holds(batch_.values.size(), batch_.stride, numbers()) || !holds(q_.size(), q_stride_, widest))
      return Status::wrong_size;

    // one number or one group of numbers a row
    offsets_per_row_ = batch_.azimuth_offsets.size() > kSlotCount;
    bounds_per_row_ = batch_.radial_bounds.size() > 2;
    if (!statuses_.empty() && statuses_.size() != count) return Status::wrong_size;
    if (!batch_.hands.empty() && batch_.hands.size() != count) return Status::wrong_size;
    if (offsets_per_row_ && batch_.azimuth_offsets.size() != count * kSlotCount) return Status::wrong_size;
    if (bounds_per_row_ && batch_.radial_bounds.size() != count * 2) return Status::wrong_size;

    // driving angles: of a slot, or of all of them
    const std::size_t angles = batch_.driving_vectors_phi.size();
    angles_ = static_cast<int>(!batch_.phi_per_row ? angles : count == 0 ? 0 : angles / count);
    if (batch_.phi_per_row && angles != count * vectors && angles != count * kSlotCount * vectors)
      return Status::wrong_size;
    return Status::ok;
  }

  // what every row is refused for: options that all rows share
  Status check_shared() const noexcept {
    using Decoder = ActionDecoder<Real>;
    constexpr std::span<const Real> none{};
    Status status = Decoder::check_offsets(offsets_per_row_ ? none : batch_.azimuth_offsets);
    if (status == Status::ok) status = Decoder::check_bounds(bounds_per_row_ ? none : batch_.radial_bounds);
    if (status == Status::ok)
      status = Decoder::check_angles(batch_.phi_per_row ? none : batch_.driving_vectors_phi, vectors());
    return status;
  }

  ActionBatch<Real> batch_;
  std::span<Real> q_;
  std::size_t q_stride_ = 0;
  std::span<Status> statuses_;
  int angles_ = 0;
  bool offsets_per_row_ = false, bounds_per_row_ = false;
  Status shared_ = Status::ok;  // of check_shared
};

/// Of the rows that were refused the first, whichever is found first.
struct FirstRefusal {
  std::size_t row = std::numeric_limits<std::size_t>::max();
  Status status = Status::ok;

  void add(const FirstRefusal& other) noexcept {
    if (other.row < row) *this = other;
  }
};

}  // namespace uhas
