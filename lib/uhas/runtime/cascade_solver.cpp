#include "uhas/runtime/cascade_solver.hpp"

#include <algorithm>
#include <string>

#include "uhas/runtime/cascade_detail.hpp"

namespace uhas {

template <class Real>
struct CascadeSolver<Real>::Model : SolverModel<Real> {
  using SolverModel<Real>::SolverModel;
};

template <class Real>
struct CascadeSolver<Real>::Scratch : Cascade<Real> {
  using Cascade<Real>::Cascade;
};

template <class Real>
CascadeSolver<Real>::CascadeSolver(const HandProfile& profile, const SolveOptions& options) {
  constexpr int max_passes = 100;
  if (options.passes < 1 || options.passes > max_passes)
    throw Error(ErrorCode::invalid_action, "", "passes is " + std::to_string(options.passes), "choose a number from 1 to 100");
  validate_profile(profile, "");
  model_ = std::make_shared<const Model>(profile, options);
  scratch_ = std::make_unique<Scratch>(*model_);
}

template <class Real>
CascadeSolver<Real>::CascadeSolver(const CascadeSolver& other)
    : model_(other.model_), scratch_(std::make_unique<Scratch>(*other.model_)) {}

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
  Scratch& cascade = *scratch_;
  if (q.size() != cascade.q.size()) return Status::wrong_size;
  const Status status = model_->decoder.decode(action, cascade.planes);
  if (status != Status::ok) return status;
  cascade.run(*model_);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = cascade.q[i] * model_->joints[i].unit;
  return Status::ok;
}

template <class Real>
Status CascadeSolver<Real>::solve(const Action<Real>& action, std::span<Real> q, SolveReport& report) noexcept {
  Scratch& cascade = *scratch_;
  const auto fits = [&](std::span<std::uint8_t> flags) { return flags.empty() || flags.size() == cascade.q.size(); };
  if (!fits(report.at_limit) || !fits(report.closed)) return Status::wrong_size;
  const Status status = solve(action, q);
  if (status != Status::ok) return status;
  report.residual_rms = cascade.residual_rms(*model_);
  std::copy_n(cascade.at_limit.begin(), report.at_limit.size(), report.at_limit.begin());
  std::copy_n(cascade.closed.begin(), report.closed.size(), report.closed.begin());
  return Status::ok;
}

template class CascadeSolver<float>;
template class CascadeSolver<double>;

}  // namespace uhas
