#include "uhas/runtime/cascade_solver.hpp"

#include "uhas/runtime/cascade/single_hand.hpp"

namespace uhas {

template <class Real>
struct CascadeSolver<Real>::Scratch : SingleHand<Real> {
  using SingleHand<Real>::SingleHand;
};

template <class Real>
CascadeSolver<Real>::CascadeSolver(const HandProfile& profile, const SolveOptions& options) {
  model_ = compile_solver_model<Real>(profile, options);
  scratch_ = std::make_unique<Scratch>(*model_);
}

template <class Real>
CascadeSolver<Real>::CascadeSolver(const CascadeSolver& other)
    : model_(other.model_), scratch_(std::make_unique<Scratch>(*other.scratch_)) {}

template <class Real>
CascadeSolver<Real>& CascadeSolver<Real>::operator=(const CascadeSolver& other) {
  return *this = CascadeSolver(other);
}

template <class Real>
CascadeSolver<Real>::CascadeSolver(CascadeSolver&&) noexcept = default;
template <class Real>
CascadeSolver<Real>& CascadeSolver<Real>::operator=(CascadeSolver&&) noexcept = default;
template <class Real>
CascadeSolver<Real>::~CascadeSolver() = default;

template <class Real>
int CascadeSolver<Real>::joint_count() const noexcept {
  return static_cast<int>(model_->joints.size());
}

template <class Real>
Status CascadeSolver<Real>::solve(const Action<Real>& action, std::span<Real> q) noexcept {
  if (q.size() != model_->joints.size()) return Status::wrong_size;
  if (const Status status = model_->decoder.check(action); status != Status::ok) return status;
  scratch_->solve(model_->decoder.numbers_of(action), q);
  return Status::ok;
}

template <class Real>
Status CascadeSolver<Real>::solve(const Action<Real>& action, std::span<Real> q, SolveReport& report) noexcept {
  // flags for every joint, or none
  const auto fits = [&](std::span<std::uint8_t> flags) {
    return flags.empty() || flags.size() == model_->joints.size();
  };
  if (!fits(report.at_limit) || !fits(report.closed)) return Status::wrong_size;
  const Status status = solve(action, q);
  if (status != Status::ok) return status;
  scratch_->report(model_->decoder.numbers_of(action), q, report);
  return Status::ok;
}

template class CascadeSolver<float>;
template class CascadeSolver<double>;

}  // namespace uhas
