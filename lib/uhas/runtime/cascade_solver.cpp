#include "uhas/runtime/cascade_solver.hpp"

#include "uhas/runtime/cascade/contact_rule.hpp"
#include "uhas/runtime/cascade/point_targets.hpp"
#include "uhas/runtime/lanes/cascade_lanes_kernel.hpp"

namespace uhas {
namespace {

struct Here {};

/// 128 bits of points at a time, where a patch is visited point by point.
template <class Real>
using Wide = Lanes<Real, 16 / int(sizeof(Real)), Here>;

}  // namespace

template <class Real>
struct CascadeSolver<Real>::Scratch : Cascade<Real, Wide<Real>> {
  using Cascade<Real, Wide<Real>>::Cascade;
};

template <class Real>
CascadeSolver<Real>::CascadeSolver(const HandProfile& profile, const SolveOptions& options) {
  model_ = compile_solver_model<Real>(profile, options);
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
  if (q.size() != model_->joints.size()) return Status::wrong_size;
  if (const Status status = model_->decoder.check(action); status != Status::ok) return status;
  // numbers to the deformation of each finger's plane, deformations to joint values
  Scratch& cascade = *scratch_;
  model_->decoder.decode(model_->decoder.numbers_of(action), cascade.planes.data());
  cascade.run(*model_);
  // out in the profile's units
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = model_->joints[i].in_profile_units(cascade.q(static_cast<int>(i)));
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
  // the scratch still holds the solve
  Scratch& cascade = *scratch_;
  report.residual_rms = cascade.residual_rms(*model_);
  for (std::size_t i = 0; i < report.at_limit.size(); ++i) report.at_limit[i] = cascade.at_limit(static_cast<int>(i));
  for (std::size_t i = 0; i < report.closed.size(); ++i) report.closed[i] = cascade.closed(static_cast<int>(i));
  return Status::ok;
}

template <>
CascadeLanes<float> cascade_lanes_scalar() {
  return CascadeLanesOf<float, Wide<float>>::functions();
}
template <>
CascadeLanes<double> cascade_lanes_scalar() {
  return CascadeLanesOf<double, Wide<double>>::functions();
}

template class CascadeSolver<float>;
template class CascadeSolver<double>;

}  // namespace uhas
