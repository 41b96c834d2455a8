#include "uhas/runtime/retarget.hpp"

#include "uhas/base/each_row.hpp"

namespace uhas {

template <class Real>
Retargeter<Real>::Retargeter(const HandProfile& from, const HandProfile& to, const SolveOptions& options,
                             int driving_vectors)
    : encoder_(from, options, driving_vectors), solver_(to, options), action_(encoder_.action_size()) {}

template <class Real>
Status Retargeter<Real>::retarget(std::span<const Real> q_from, std::span<Real> q_to, EncodeReport& report) noexcept {
  if (q_to.size() != std::size_t(joint_count_to())) return Status::wrong_size;
  if (const Status status = encoder_.encode(q_from, action_, report); status != Status::ok) return status;
  return solver_.solve({.values = action_, .driving_vectors_phi = {}}, q_to);
}

template <class Real>
Status Retargeter<Real>::retarget_batch(std::span<const Real> q_from, std::span<Real> q_to,
                                        std::span<EncodeReport> reports, std::span<Status> statuses) noexcept {
  const std::size_t from = joint_count_from(), to = joint_count_to(), count = q_from.size() / from;
  if (q_from.size() != count * from || q_to.size() != count * to || (!reports.empty() && reports.size() != count) ||
      !holds_statuses(statuses, count))
    return Status::wrong_size;
  EncodeReport unwanted;
  return each_row(count, statuses, [&](std::size_t row) {
    return retarget(q_from.subspan(row * from, from), q_to.subspan(row * to, to),
                    reports.empty() ? unwanted : reports[row]);
  });
}

template class Retargeter<float>;
template class Retargeter<double>;

}  // namespace uhas
