#include "uhas/runtime/batch_solver.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "uhas/runtime/lanes/batch_rows.hpp"
#include "uhas/runtime/lanes/cascade_lanes.hpp"
#include "uhas/runtime/lanes/lane_queue.hpp"
#include "uhas/runtime/lanes/row_chunks.hpp"
#include "uhas/runtime/lanes/worker_pool.hpp"

namespace uhas {
namespace {

template <class Real>
CascadeLanes<Real> lanes_of(InstructionSet set) {
#ifdef UHAS_HAS_AVX2_SOURCES
  if (set == InstructionSet::avx2) return cascade_lanes_avx2<Real>();
#endif
  return set == InstructionSet::baseline ? cascade_lanes_baseline<Real>() : cascade_lanes_scalar<Real>();
}

}  // namespace

/// The hands, the threads, and what each thread keeps of each hand.
template <class Real>
class BatchSolver<Real>::Crew {
 public:
  Crew(std::span<const HandProfile> hands, const SolveOptions& options, const BatchOptions& batch)
      : lanes_(lanes_of<Real>(has_lanes(options) ? batch.instruction_set : InstructionSet::scalar)),
        pool_(batch.threads),
        workers_(batch.threads) {
    for (const HandProfile& profile : hands) models_.push_back(compile_solver_model<Real>(profile, options));
    for (Worker& worker : workers_)
      for (const auto& model : models_) worker.queues.emplace_back(lanes_, model);
  }

  int hand_count() const noexcept { return static_cast<int>(models_.size()); }
  int joint_count(int hand) const noexcept { return static_cast<int>(models_[hand]->joints.size()); }
  int widest_joint_count() const noexcept {
    int widest = 0;
    for (int hand = 0; hand < hand_count(); ++hand) widest = std::max(widest, joint_count(hand));
    return widest;
  }
  int lanes() const noexcept { return lanes_.width; }

  Status solve(const ActionBatch<Real>& actions, std::span<Real> q, std::span<Status> statuses,
               std::size_t q_stride) noexcept {
    const Status status = rows_.set(actions, q, q_stride, statuses, widest_joint_count());
    if (status != Status::ok || rows_.count() == 0) return status;

    chunks_.start(rows_.count());
    for (Worker& worker : workers_) worker.refusal = {};
    // to wake a thread costs more than it would take off the caller
    if (rows_.count() < 2 * RowChunks::kRows)
      work(0);
    else
      pool_.run([](void* crew, int worker) { static_cast<Crew*>(crew)->work(worker); }, this);

    FirstRefusal first;
    for (const Worker& worker : workers_) first.add(worker.refusal);
    return first.status;
  }

 private:
  struct Worker {
    std::vector<LaneQueue<Real>> queues;  // [hand]
    FirstRefusal refusal;
  };

  static bool has_lanes(const SolveOptions& options) {
    return options.rule == CascadeRule::correspondence && options.field == FieldReading::finger;
  }

  void work(int index) noexcept {
    Worker& worker = workers_[index];
    for (RowChunks::Chunk chunk = chunks_.take(); !chunk.empty(); chunk = chunks_.take())
      for (std::size_t row = chunk.begin; row < chunk.end; ++row) take(worker, row);
    for (LaneQueue<Real>& queue : worker.queues) queue.finish(rows_);
  }

  void take(Worker& worker, std::size_t row) noexcept {
    const Status status = rows_.judge(row, hand_count());
    if (status == Status::ok)
      worker.queues[rows_.hand(row)].push(rows_, row);
    else
      worker.refusal.add({row, status});
  }

  CascadeLanes<Real> lanes_;
  WorkerPool pool_;
  std::vector<std::shared_ptr<const SolverModel<Real>>> models_;  // [hand]
  std::vector<Worker> workers_;                                   // [thread]
  BatchRows<Real> rows_;                                          // of the present batch
  RowChunks chunks_;
};

template <class Real>
BatchSolver<Real>::BatchSolver(const HandProfile& profile, const SolveOptions& options, const BatchOptions& batch)
    : BatchSolver(std::span(&profile, 1), options, batch) {}

template <class Real>
BatchSolver<Real>::BatchSolver(std::span<const HandProfile> hands, const SolveOptions& options,
                               const BatchOptions& batch) {
  constexpr int most_threads = 256;
  if (hands.empty()) throw Error(ErrorCode::invalid_option, "", "hands is empty", "give it one profile or more");
  if (batch.threads < 1 || batch.threads > most_threads)
    throw Error(ErrorCode::invalid_option, "", "threads is " + std::to_string(batch.threads),
                "choose a number from 1 to 256");
  if (!is_available(batch.instruction_set))
    throw Error(
        ErrorCode::invalid_option, "",
        std::string("instruction_set is ") + to_string(batch.instruction_set) + ", which this machine or build has not",
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
