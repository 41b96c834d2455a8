// Rows of one hand that wait until there is one for each lane.
#pragma once

#include <memory>
#include <utility>

#include "uhas/runtime/lanes/batch_rows.hpp"
#include "uhas/runtime/lanes/cascade_lanes.hpp"

namespace uhas {

/// What a thread keeps of a hand: memory to solve in, and the rows that wait.
template <class Real>
class LaneQueue {
 public:
  LaneQueue(const CascadeLanes<Real>& lanes, std::shared_ptr<const SolverModel<Real>> model)
      : lanes_(lanes), model_(std::move(model)), scratch_(lanes.make(*model_), lanes.destroy) {}

  /// Adds a row that `rows.judge` found sound, and solves when the lanes are full.
  void push(const BatchRows<Real>& rows, std::size_t row) noexcept {
    const Action<Real> action = rows.action(row);
    waiting_.values[waiting_.count] = action.values.data();
    waiting_.phi[waiting_.count] = action.driving_vectors_phi.data();
    waiting_.azimuth_offsets[waiting_.count] = data_or_null(action.azimuth_offsets);
    waiting_.radial_bounds[waiting_.count] = data_or_null(action.radial_bounds);
    waiting_.q[waiting_.count] = rows.q(row);
    if (++waiting_.count == lanes_.width) take(rows);
  }

  /// Solves what still waits.
  void finish(const BatchRows<Real>& rows) noexcept {
    take(rows);
    lanes_.finish(scratch_.get());
  }

 private:
  /// The rows that wait, if any. Lanes that have none repeat the first.
  void take(const BatchRows<Real>& rows) noexcept {
    if (waiting_.count == 0) return;
    for (int l = waiting_.count; l < lanes_.width; ++l) {
      waiting_.values[l] = waiting_.values[0];
      waiting_.phi[l] = waiting_.phi[0];
      waiting_.azimuth_offsets[l] = waiting_.azimuth_offsets[0];
      waiting_.radial_bounds[l] = waiting_.radial_bounds[0];
    }
    waiting_.vectors = rows.vectors();
    waiting_.angles = rows.angles();
    waiting_.common_phi = rows.have_common_angles();
    waiting_.normalized = rows.are_normalized();
    lanes_.take(scratch_.get(), waiting_);
    waiting_.count = 0;
  }

  CascadeLanes<Real> lanes_;
  std::shared_ptr<const SolverModel<Real>> model_;
  std::unique_ptr<void, void (*)(void*)> scratch_;
  ActionRows<Real> waiting_{};  // `count` of them
};

}  // namespace uhas
