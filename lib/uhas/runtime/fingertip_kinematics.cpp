#include "uhas/runtime/fingertip_kinematics.hpp"

#include <cmath>

#include "uhas/runtime/observing/fingertip_kernel.hpp"

namespace uhas {

template <class Real>
struct FingertipKinematics<Real>::Model {
  std::vector<FingertipChain<Real>> chains;  // [finger]
  std::vector<int> independent;              // joints whose values are read
  std::size_t joints;
  FingertipKernel<Real> kernel{};  // empty for one hand after the other

  Model(const HandProfile& profile, InstructionSet set) : joints(profile.tree.joints.size()) {
    for (std::size_t f = 0; f < profile.fingers.size(); ++f)
      chains.push_back(compile_chain<Real>(profile, static_cast<int>(f)));
    for (std::size_t i = 0; i < joints; ++i)
      if (profile.tree.joints[i].mimic_master < 0) independent.push_back(static_cast<int>(i));
    kernel = kernel_for(set);
  }

  FingertipKernel<Real> kernel_for(InstructionSet set) const {
    if (set == InstructionSet::scalar || joints > kKernelJoints || chains.size() > kKernelFingers) return {};
#ifdef UHAS_HAS_AVX2_SOURCES
    if (set == InstructionSet::avx2 && is_available(set)) return fingertip_kernel_avx2<Real>();
#endif
    return fingertip_kernel_baseline<Real>();
  }

  /// One hand after the other; touches nothing when a number that is read is not finite.
  Status place_each(const Real* q, std::size_t hands, Real* fingertips) const noexcept {
    for (std::size_t n = 0; n < hands; ++n)
      for (int i : independent)
        if (!std::isfinite(q[n * joints + i])) return Status::non_finite_input;
    const auto turn = [](Real angle, Real& cosine, Real& sine) { cosine = std::cos(angle), sine = std::sin(angle); };
    for (std::size_t n = 0; n < hands; ++n) {
      for (const FingertipChain<Real>& chain : chains) {
        const Vector3<Real> p = place_fingertip<Real>(
            chain, [&](int joint) { return q[n * joints + joint]; }, turn);
        fingertips[0] = p.x, fingertips[1] = p.y, fingertips[2] = p.z;
        fingertips += 3;
      }
    }
    return Status::ok;
  }
};

template <class Real>
FingertipKinematics<Real>::FingertipKinematics(const HandProfile& profile, InstructionSet set) {
  validate_profile(profile, "");
  model_ = std::make_shared<const Model>(profile, set);
}

template <class Real>
int FingertipKinematics<Real>::joint_count() const noexcept {
  return static_cast<int>(model_->joints);
}

template <class Real>
int FingertipKinematics<Real>::finger_count() const noexcept {
  return static_cast<int>(model_->chains.size());
}

template <class Real>
Status FingertipKinematics<Real>::fingertips(std::span<const Real> q, std::span<Real> fingertips) const noexcept {
  if (q.size() != model_->joints || fingertips.size() != 3 * model_->chains.size()) return Status::wrong_size;
  return model_->place_each(q.data(), 1, fingertips.data());
}

template <class Real>
Status FingertipKinematics<Real>::fingertips_batch(std::span<const Real> q, std::span<Real> fingertips) const noexcept {
  const Model& model = *model_;
  const std::size_t count = q.size() / model.joints;
  if (q.size() != count * model.joints || fingertips.size() != count * 3 * model.chains.size())
    return Status::wrong_size;
  if (!model.kernel.place || !model.kernel.takes(q.data(), q.size()))
    return model.place_each(q.data(), count, fingertips.data());
  model.kernel.place(model.chains.data(), model.chains.size(), q.data(), model.joints, count, fingertips.data());
  return Status::ok;
}

template class FingertipKinematics<float>;
template class FingertipKinematics<double>;

}  // namespace uhas
