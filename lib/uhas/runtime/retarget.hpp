// Retarget: the posture of one hand on another, by way of the action that both understand
// (docs/method.md#encode-and-retarget).
#pragma once

#include <vector>

#include "uhas/runtime/encoder.hpp"

namespace uhas {

/// Encodes on the hand `from`, solves on the hand `to`. Copies share the constant models and have scratch memory of
/// their own: give each thread its copy. Constructing may throw and allocates; retargeting does neither.
template <class Real>
class Retargeter {
 public:
  /// @param options          of both solvers
  /// @param driving_vectors  V, 1 to 4: more follow `from` more closely and ask more of `to`
  /// Throws Error as Encoder.
  Retargeter(const HandProfile& from, const HandProfile& to, const SolveOptions& options = {}, int driving_vectors = 2)
      : encoder_(from, options, driving_vectors), solver_(to, options), action_(encoder_.action_size()) {}

  int joint_count_from() const noexcept { return encoder_.joint_count(); }
  int joint_count_to() const noexcept { return solver_.joint_count(); }

  /// @param q_from  [joints of `from`] as Encoder takes them
  /// @param q_to    [joints of `to`] rad (m for sliding joints), within limits
  /// @param report  what `from` lost on the way: the distance of `q_from` from the postures that an action can give
  /// On any status but ok `q_to` and `report` are untouched.
  Status retarget(std::span<const Real> q_from, std::span<Real> q_to, EncodeReport& report) noexcept {
    if (q_to.size() != std::size_t(joint_count_to())) return Status::wrong_size;
    if (const Status status = encoder_.encode(q_from, action_, report); status != Status::ok) return status;
    return solver_.solve({.values = action_, .driving_vectors_phi = {}}, q_to);
  }

  /// The same for N postures, one after the other, on the calling thread: q_from [N][joints of from] to q_to [N][joints
  /// of to] and reports [N], which may be empty. One bad number refuses the whole batch.
  Status retarget_batch(std::span<const Real> q_from, std::span<Real> q_to, std::span<EncodeReport> reports) noexcept {
    const std::size_t from = joint_count_from(), to = joint_count_to(), count = q_from.size() / from;
    if (q_to.size() != count * to || (!reports.empty() && reports.size() != count)) return Status::wrong_size;
    if (const Status status = encoder_.check(q_from); status != Status::ok) return status;
    EncodeReport report;
    for (std::size_t n = 0; n < count; ++n) {
      retarget(q_from.subspan(n * from, from), q_to.subspan(n * to, to), report);
      if (!reports.empty()) reports[n] = report;
    }
    return Status::ok;
  }

  /// What a retargeting of `q_from` [N][joints of from] would be refused for: ok, wrong_size or non_finite_input.
  Status check(std::span<const Real> q_from) const noexcept { return encoder_.check(q_from); }

 private:
  Encoder<Real> encoder_;
  CascadeSolver<Real> solver_;
  std::vector<Real> action_;  // [5 + 5 V]
};

}  // namespace uhas
