// The cascade for thousands of hands: N actions become N postures, a hand a SIMD lane, on as many threads as asked for.
//
//   uhas::BatchSolver<float> solver(uhas::read_profile("hand.h5"), {}, {.threads = 4});
//   std::vector<float> q(count * solver.joint_count());
//   uhas::Status status = solver.solve({.count = count, .values = actions}, q);
//
// Constructing may throw, allocates and starts the threads. With one thread, solving neither throws, allocates, locks
// nor reads a clock; with several it wakes the others and waits for them, and nothing else. After a fork() the child has
// no such threads: there, make a solver with threads anew, and neither use nor destroy the old one.
//
// A row's result does not depend on the other rows, on their order or on the number of threads, bit for bit. Between
// instruction sets, and against a single solve, rounding differs: 1e-10 rad in double and 1e-4 rad in float, except
// where an action stands within rounding of a branch (a target passing behind a joint).
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "uhas/base/errors.hpp"
#include "uhas/base/export.hpp"
#include "uhas/runtime/action.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/instruction_set.hpp"

namespace uhas {

/// N actions, caller-owned. Meanings, units and bounds are those of Action.
template <class Real>
struct ActionBatch {
  std::size_t count = 0;                        ///< N
  std::span<const Real> values;                 ///< [N][5 + 5 V]
  int driving_vectors = 2;                      ///< V, 1 to 4
  std::size_t stride = 0;                       ///< numbers from one row of `values` to the next; 0 = 5 + 5 V
  std::span<const Real> driving_vectors_phi{};  ///< empty = pi j / (V + 1); [V] or [5 V], see `phi_per_row`
  bool phi_per_row = false;                 ///< `driving_vectors_phi` is [N][V] or [N][5 V], not the same for all rows
  bool normalized = false;                  ///< as in Action
  std::span<const Real> azimuth_offsets{};  ///< empty; [5] for all rows; or [N][5]
  std::span<const Real> radial_bounds{};    ///< empty = those of the convention; [2] for all rows; or [N][2]
  std::span<const int> hands{};             ///< [N] the hand each row is for; empty = the first
};

struct BatchOptions {
  int threads = 1;  ///< 1 to 256, the calling one included
  InstructionSet instruction_set = widest_instruction_set();
};

/// Solves batches for one hand, or for a mixed set of hands. One batch at a time: give each caller an object of its
/// own. Rows whose options have no lanes, those of the rule `contact` and of the field reading `field`, are solved one
/// after the other by the code of CascadeSolver; threads still help.
template <class Real>
class UHAS_API BatchSolver {
 public:
  /// Throws Error: as CascadeSolver; invalid_option for no hand, for threads out of range and for an instruction set
  /// that is not available; std::system_error when a thread cannot be started.
  explicit BatchSolver(const HandProfile& profile, const SolveOptions& options = {}, const BatchOptions& batch = {});
  explicit BatchSolver(std::span<const HandProfile> hands, const SolveOptions& options = {},
                       const BatchOptions& batch = {});
  BatchSolver(BatchSolver&&) noexcept;
  BatchSolver& operator=(BatchSolver&&) noexcept;
  ~BatchSolver();

  int hand_count() const noexcept;
  int joint_count(int hand = 0) const noexcept;  ///< every joint of the hand's profile, mimic followers included
  int widest_joint_count() const noexcept;       ///< the largest of these: numbers of an output row
  int lanes() const noexcept;                    ///< hands solved at once on a thread

  /// Refuses row by row, as `Status` says.
  /// @param q         [N][q_stride] joint angles (rad; m for prismatic joints) in the order of the row's own hand,
  ///                  within limits. Elements past that hand's joints are untouched.
  /// @param statuses  [N] or empty: non_finite_input, invalid_driving_vectors, invalid_radial_bounds, unknown_hand or ok
  /// @param q_stride  numbers from one row of `q` to the next; 0 = widest_joint_count()
  Status solve(const ActionBatch<Real>& actions, std::span<Real> q, std::span<Status> statuses = {},
               std::size_t q_stride = 0) noexcept;

 private:
  class UHAS_PRIVATE Crew;
  std::unique_ptr<Crew> crew_;
};

extern template class BatchSolver<float>;
extern template class BatchSolver<double>;

}  // namespace uhas
