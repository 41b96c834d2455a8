#include "uhas/runtime/observation.hpp"

#include <cmath>

#include "uhas/runtime/lanes/wide_rows.hpp"
#include "uhas/runtime/observing/observation_kernel.hpp"

namespace uhas {

template <class Real>
struct Observer<Real>::Model : ObservationModel<Real> {
  ObservationKernel<Real> kernel;  // empty for one hand after the other

  Model(const HandProfile& profile, const ObservationOptions& options, InstructionSet set)
      : ObservationModel<Real>(compile_observation<Real>(profile, options)), kernel(kernel_for(set)) {}

  ObservationKernel<Real> kernel_for(InstructionSet set) const {
    if (set == InstructionSet::scalar || this->joints.size() > kObservedJoints) return {};
#ifdef UHAS_HAS_AVX2_SOURCES
    if (set == InstructionSet::avx2 && is_available(set)) return observation_kernel_avx2<Real>();
#endif
    return observation_kernel_baseline<Real>();
  }
};

template <class Real>
Observer<Real>::Observer(const HandProfile& profile, const ObservationOptions& options, InstructionSet set) {
  validate_profile(profile, "");
  model_ = std::make_shared<const Model>(profile, options, set);
  bodies_.resize(model_->joints.size());
}

template <class Real>
int Observer<Real>::joint_count() const noexcept {
  return static_cast<int>(bodies_.size());
}

template <class Real>
int Observer<Real>::size() const noexcept {
  return model_->size;
}

template <class Real>
Status Observer<Real>::observe(std::span<const Real> q, std::span<const Real> qd,
                               std::span<Real> observation) noexcept {
  if (q.size() != bodies_.size() || qd.size() != q.size() || observation.size() != std::size_t(model_->size))
    return Status::wrong_size;
  return observe_one(q.data(), qd.data(), observation.data());
}

template <class Real>
Status Observer<Real>::observe_batch(std::span<const Real> q, std::span<const Real> qd, std::span<Real> observations,
                                     std::span<Status> statuses) noexcept {
  const Model& model = *model_;
  const ObservationKernel<Real>& kernel = model.kernel;
  const std::size_t joints = bodies_.size(), count = q.size() / joints;
  if (q.size() != count * joints || qd.size() != q.size() || observations.size() != count * model.size ||
      !holds_statuses(statuses, count))
    return Status::wrong_size;
  const auto q_of = [&](std::size_t row) { return q.data() + row * joints; };
  const auto qd_of = [&](std::size_t row) { return qd.data() + row * joints; };
  const auto out_of = [&](std::size_t row) { return observations.data() + row * model.size; };
  return wide_rows(
      count, statuses,
      [&](std::size_t first, std::size_t rows) {
        return kernel.observe && kernel.takes(q_of(first), rows * joints) && kernel.takes(qd_of(first), rows * joints);
      },
      [&](std::size_t first, std::size_t rows) {
        kernel.observe(model, q_of(first), qd_of(first), rows, out_of(first));
      },
      [&](std::size_t row) { return observe_one(q_of(row), qd_of(row), out_of(row)); });
}

template <class Real>
Status Observer<Real>::observe_one(const Real* q, const Real* qd, Real* observation) noexcept {
  for (const auto& joint : model_->joints)
    if (!std::isfinite(q[joint.source]) || !std::isfinite(qd[joint.source])) return Status::non_finite_input;
  const auto turn = [](Real angle) { return SinCos<Real>{.sine = std::sin(angle), .cosine = std::cos(angle)}; };
  move_bodies<Real, Real>(*model_, q, qd, turn, bodies_.data());
  write_observation<Real, Real>(*model_, bodies_.data(), observation);
  return Status::ok;
}

template class Observer<float>;
template class Observer<double>;

}  // namespace uhas
