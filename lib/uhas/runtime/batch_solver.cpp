#include "uhas/runtime/batch_solver.hpp"

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "uhas/runtime/lanes/cascade_lanes.hpp"
#include "uhas/runtime/lanes/worker_pool.hpp"

namespace uhas {
namespace {

/// Rows that a thread takes at once.
constexpr std::size_t kChunk = 64;

template <class Real>
CascadeLanes<Real> lanes_of(InstructionSet set) {
#ifdef UHAS_HAS_AVX2_SOURCES
  if (set == InstructionSet::avx2) return cascade_lanes_avx2<Real>();
#endif
  return set == InstructionSet::baseline ? cascade_lanes_baseline<Real>() : cascade_lanes_scalar<Real>();
}

}  // namespace

/// The hands and the threads that solve for them.
template <class Real>
class BatchSolver<Real>::Crew {
 public:
  Crew(std::span<const HandProfile> hands, const SolveOptions& options, const BatchOptions& batch)
      : lanes_(lanes_of<Real>(options.rule == CascadeRule::correspondence && options.field == FieldReading::finger
                                  ? batch.instruction_set
                                  : InstructionSet::scalar)),
        pool_(batch.threads) {
    for (const HandProfile& profile : hands) {
      models_.push_back(compile_solver_model<Real>(profile, options));
      widest_ = std::max(widest_, static_cast<int>(models_.back()->joints.size()));
    }
    workers_.resize(batch.threads);
    for (Worker& worker : workers_)
      for (const auto& model : models_) worker.hands.push_back({Scratch(lanes_.make(*model), lanes_.destroy), {}, {}});
  }

  int hand_count() const noexcept { return static_cast<int>(models_.size()); }
  int joint_count(int hand) const noexcept { return static_cast<int>(models_[hand]->joints.size()); }
  int widest_joint_count() const noexcept { return widest_; }
  int lanes() const noexcept { return lanes_.width; }

  Status solve(const ActionBatch<Real>& actions, std::span<Real> q, std::span<Status> statuses,
               std::size_t q_stride) noexcept {
    const int vectors = actions.driving_vectors;
    if (vectors < 1 || vectors > kMaxDrivingVectors) return Status::wrong_size;
    numbers_ = kSlotCount * (1 + vectors);
    batch_ = actions;
    if (batch_.stride == 0) batch_.stride = numbers_;
    q_ = q.data();
    q_stride_ = q_stride == 0 ? std::size_t(widest_) : q_stride;
    statuses_ = statuses;
    const Status status = check_sizes(q.size());
    if (status != Status::ok || actions.count == 0) return status;

    next_row_.store(0, std::memory_order_relaxed);
    pool_.run([](void* crew, int worker) { static_cast<Crew*>(crew)->work(worker); }, this);
    const auto refused = std::min_element(workers_.begin(), workers_.end(), [](const Worker& a, const Worker& b) {
      return a.first_refused < b.first_refused;
    });
    return refused->refusal;
  }

 private:
  using Scratch = std::unique_ptr<void, void (*)(void*)>;

  /// What a thread keeps of a hand: memory to solve in, and rows that wait until the lanes are full.
  struct Bench {
    Scratch scratch;
    ActionRows<Real> rows;
    std::size_t waiting;
  };

  struct Worker {
    std::vector<Bench> hands;
    std::size_t first_refused;
    Status refusal;
  };

  Status check_sizes(std::size_t q_size) noexcept {
    const auto holds = [&](std::size_t size, std::size_t stride, std::size_t width) {
      return batch_.count == 0 || (stride >= width && size >= width && (size - width) / stride >= batch_.count - 1);
    };
    // the last row of a mixed set may be of a hand with few joints; its length is not looked at
    if (!holds(batch_.values.size(), batch_.stride, numbers_) || !holds(q_size, q_stride_, widest_))
      return Status::wrong_size;
    if (!statuses_.empty() && statuses_.size() != batch_.count) return Status::wrong_size;
    offsets_per_row_ = batch_.azimuth_offsets.size() > kSlotCount;
    bounds_per_row_ = batch_.radial_bounds.size() > 2;
    if (offsets_per_row_ && batch_.azimuth_offsets.size() != batch_.count * kSlotCount) return Status::wrong_size;
    if (bounds_per_row_ && batch_.radial_bounds.size() != batch_.count * 2) return Status::wrong_size;
    if (const Status status = ActionDecoder<Real>::check_offsets(offsets_per_row_ ? kNothing : batch_.azimuth_offsets);
        status != Status::ok)
      return status;
    if (const Status status = ActionDecoder<Real>::check_bounds(bounds_per_row_ ? kNothing : batch_.radial_bounds);
        status != Status::ok)
      return status;
    if (!batch_.hands.empty() && batch_.hands.size() != batch_.count) return Status::wrong_size;

    const std::size_t angles = batch_.driving_vectors_phi.size(), vectors = batch_.driving_vectors;
    if (!batch_.phi_per_row) {
      angles_ = static_cast<int>(angles);
      return ActionDecoder<Real>::check_angles(batch_.driving_vectors_phi, batch_.driving_vectors);
    }
    if (angles != batch_.count * vectors && angles != batch_.count * kSlotCount * vectors) return Status::wrong_size;
    angles_ = batch_.count == 0 ? 0 : static_cast<int>(angles / batch_.count);
    return Status::ok;
  }

  /// Takes rows until none is left.
  void work(int index) noexcept {
    Worker& worker = workers_[index];
    worker.first_refused = batch_.count;
    worker.refusal = Status::ok;
    for (Bench& bench : worker.hands) bench.waiting = 0;
    while (true) {
      const std::size_t first = next_row_.fetch_add(kChunk, std::memory_order_relaxed);
      if (first >= batch_.count) break;
      for (std::size_t row = first; row < std::min(first + kChunk, batch_.count); ++row) take(worker, row);
    }
    for (int hand = 0; hand < hand_count(); ++hand) flush(worker.hands[hand], hand);
  }

  void take(Worker& worker, std::size_t row) noexcept {
    const auto part = [&](std::span<const Real> numbers, bool per_row, std::size_t width) {
      return per_row ? numbers.subspan(row * width, width) : numbers;
    };
    const std::span<const Real> values = batch_.values.subspan(row * batch_.stride, numbers_);
    const std::span<const Real> phi = part(batch_.driving_vectors_phi, batch_.phi_per_row, angles_);
    const std::span<const Real> offsets = part(batch_.azimuth_offsets, offsets_per_row_, kSlotCount);
    const std::span<const Real> bounds = part(batch_.radial_bounds, bounds_per_row_, 2);
    const int hand = batch_.hands.empty() ? 0 : batch_.hands[row];
    Status status = hand < 0 || hand >= hand_count() ? Status::unknown_hand : Status::ok;
    if (status == Status::ok)  // what all rows share has been checked
      status = ActionDecoder<Real>::check({.values = values,
                                           .driving_vectors_phi = batch_.phi_per_row ? phi : kNothing,
                                           .azimuth_offsets = offsets_per_row_ ? offsets : kNothing,
                                           .radial_bounds = bounds_per_row_ ? bounds : kNothing});
    if (!statuses_.empty()) statuses_[row] = status;
    if (status != Status::ok) {
      if (row < worker.first_refused) worker.first_refused = row, worker.refusal = status;
      return;
    }
    Bench& bench = worker.hands[hand];
    bench.rows.values[bench.waiting] = values.data();
    bench.rows.phi[bench.waiting] = phi.data();
    bench.rows.azimuth_offsets[bench.waiting] = data_or_null(offsets);
    bench.rows.radial_bounds[bench.waiting] = data_or_null(bounds);
    bench.rows.q[bench.waiting] = q_ + row * q_stride_;
    if (++bench.waiting == std::size_t(lanes_.width)) flush(bench, hand);
  }

  /// Solves the rows that wait. Lanes that have none repeat the first.
  void flush(Bench& bench, int hand) noexcept {
    if (bench.waiting == 0) return;
    for (int l = static_cast<int>(bench.waiting); l < lanes_.width; ++l) {
      bench.rows.values[l] = bench.rows.values[0];
      bench.rows.phi[l] = bench.rows.phi[0];
      bench.rows.azimuth_offsets[l] = bench.rows.azimuth_offsets[0];
      bench.rows.radial_bounds[l] = bench.rows.radial_bounds[0];
    }
    bench.rows.count = static_cast<int>(bench.waiting);
    bench.rows.vectors = batch_.driving_vectors;
    bench.rows.angles = angles_;
    bench.rows.common_phi = !batch_.phi_per_row;
    bench.rows.normalized = batch_.normalized;
    lanes_.solve(bench.scratch.get(), *models_[hand], bench.rows);
    bench.waiting = 0;
  }

  static constexpr std::span<const Real> kNothing{};

  CascadeLanes<Real> lanes_;
  WorkerPool pool_;
  std::vector<std::shared_ptr<const SolverModel<Real>>> models_;  // [hand]
  std::vector<Worker> workers_;                                   // [thread]
  int widest_ = 0;

  // the present batch
  ActionBatch<Real> batch_;
  Real* q_ = nullptr;
  std::size_t q_stride_ = 0;
  std::span<Status> statuses_;
  int numbers_ = 0, angles_ = 0;  // of a row
  bool offsets_per_row_ = false, bounds_per_row_ = false;
  std::atomic<std::size_t> next_row_{0};
};

template <class Real>
BatchSolver<Real>::BatchSolver(const HandProfile& profile, const SolveOptions& options, const BatchOptions& batch)
    : BatchSolver(std::span(&profile, 1), options, batch) {}

template <class Real>
BatchSolver<Real>::BatchSolver(std::span<const HandProfile> hands, const SolveOptions& options,
                               const BatchOptions& batch) {
  constexpr int most_threads = 256;
  if (hands.empty())
    throw Error(ErrorCode::invalid_action, "", "a batch solver needs a hand", "give it one profile or more");
  if (batch.threads < 1 || batch.threads > most_threads)
    throw Error(ErrorCode::invalid_action, "", "threads is " + std::to_string(batch.threads),
                "choose a number from 1 to 256");
  if (!is_available(batch.instruction_set))
    throw Error(ErrorCode::invalid_action, "",
                std::string("this machine or build has no ") + to_string(batch.instruction_set),
                "leave the choice to the library");
  crew_ = std::make_unique<Crew>(hands, options, batch);
}

template <class Real>
BatchSolver<Real>::BatchSolver(BatchSolver&&) noexcept = default;
template <class Real>
BatchSolver<Real>& BatchSolver<Real>::operator=(BatchSolver&&) noexcept = default;
template <class Real>
BatchSolver<Real>::~BatchSolver() = default;

template <class Real>
int BatchSolver<Real>::hand_count() const noexcept {
  return crew_->hand_count();
}
template <class Real>
int BatchSolver<Real>::joint_count(int hand) const noexcept {
  return crew_->joint_count(hand);
}
template <class Real>
int BatchSolver<Real>::widest_joint_count() const noexcept {
  return crew_->widest_joint_count();
}
template <class Real>
int BatchSolver<Real>::lanes() const noexcept {
  return crew_->lanes();
}

template <class Real>
Status BatchSolver<Real>::solve(const ActionBatch<Real>& actions, std::span<Real> q, std::span<Status> statuses,
                                std::size_t q_stride) noexcept {
  return crew_->solve(actions, q, statuses, q_stride);
}

template class BatchSolver<float>;
template class BatchSolver<double>;

}  // namespace uhas
