#include "uhas/runtime/observation.hpp"

#include <cmath>

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
  return observe_each(q.data(), qd.data(), 1, observation.data());
}

template <class Real>
Status Observer<Real>::observe_batch(std::span<const Real> q, std::span<const Real> qd,
                                     std::span<Real> observations) noexcept {
  const Model& model = *model_;
  const std::size_t joints = bodies_.size(), count = q.size() / joints;
  if (q.size() != count * joints || qd.size() != q.size() || observations.size() != count * model.size)
    return Status::wrong_size;
  if (!model.kernel.observe || !model.kernel.takes(q.data(), q.size()) || !model.kernel.takes(qd.data(), qd.size()))
    return observe_each(q.data(), qd.data(), count, observations.data());
  model.kernel.observe(model, q.data(), qd.data(), count, observations.data());
  return Status::ok;
}

template <class Real>
Status Observer<Real>::observe_each(const Real* q, const Real* qd, std::size_t count, Real* observations) noexcept {
  const std::size_t joints = bodies_.size();
  for (std::size_t n = 0; n < count; ++n)
    for (const auto& joint : model_->joints)
      if (!std::isfinite(q[n * joints + joint.source]) || !std::isfinite(qd[n * joints + joint.source]))
        return Status::non_finite_input;
  const auto turn = [](Real angle) { return SinCos<Real>{.sine = std::sin(angle), .cosine = std::cos(angle)}; };
  for (std::size_t n = 0; n < count; ++n) {
    move_bodies<Real, Real>(*model_, q + n * joints, qd + n * joints, turn, bodies_.data());
    write_observation<Real, Real>(*model_, bodies_.data(), observations + n * model_->size);
  }
  return Status::ok;
}

template class Observer<float>;
template class Observer<double>;

}  // namespace uhas
