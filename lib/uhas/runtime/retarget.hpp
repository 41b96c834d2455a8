// Retarget: the posture of one hand on another, by way of the action that both understand
// (docs/method.md#encode-and-retarget).
#pragma once

#include <vector>

#include "uhas/runtime/encoder.hpp"

namespace uhas {

/// Encodes on the hand `from`, solves on the hand `to`. Copies share the constant models and have scratch memory of
/// their own: give each thread its copy. Constructing may throw and allocates; retargeting does neither.
template <class Real>
class UHAS_API Retargeter {
 public:
  /// @param options          of both solvers
  /// @param driving_vectors  V, 1 to 4: more follow `from` more closely and ask more of `to`
  /// Throws Error as Encoder.
  Retargeter(const HandProfile& from, const HandProfile& to, const SolveOptions& options = {}, int driving_vectors = 2);

  int joint_count_from() const noexcept { return encoder_.joint_count(); }
  int joint_count_to() const noexcept { return solver_.joint_count(); }

  /// @param q_from  [joints of `from`] as Encoder takes them
  /// @param q_to    [joints of `to`] rad (m for sliding joints), within limits
  /// @param report  what `from` lost on the way: the distance of `q_from` from the postures that an action can give
  /// On any status but ok `q_to` and `report` are untouched.
  Status retarget(std::span<const Real> q_from, std::span<Real> q_to, EncodeReport& report) noexcept;

  /// The same for N postures, one after the other, on the calling thread: q_from [N][joints of `from`] to q_to
  /// [N][joints of `to`]. Refuses row by row, as `Status` says, the reports too.
  /// @param reports, statuses  [N] or empty
  Status retarget_batch(std::span<const Real> q_from, std::span<Real> q_to, std::span<EncodeReport> reports = {},
                        std::span<Status> statuses = {}) noexcept;

 private:
  Encoder<Real> encoder_;
  CascadeSolver<Real> solver_;
  std::vector<Real> action_;  // [5 + 5 V]
};

extern template class Retargeter<float>;
extern template class Retargeter<double>;

}  // namespace uhas
