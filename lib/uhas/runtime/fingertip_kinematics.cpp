#include "uhas/runtime/fingertip_kinematics.hpp"

#include <cmath>

#include "uhas/runtime/lanes/wide_rows.hpp"
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

  /// One hand; touches nothing when a number that is read is not finite.
  Status place_one(const Real* q, Real* fingertips) const noexcept {
    for (int i : independent)
      if (!std::isfinite(q[i])) return Status::non_finite_input;
    const auto turn = [](Real angle, Real& cosine, Real& sine) { cosine = std::cos(angle), sine = std::sin(angle); };
    for (const FingertipChain<Real>& chain : chains) {
      const Vector3<Real> p = place_fingertip<Real>(
          chain, [&](int joint) { return q[joint]; }, turn);
      fingertips[0] = p.x, fingertips[1] = p.y, fingertips[2] = p.z;
      fingertips += 3;
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
  return model_->place_one(q.data(), fingertips.data());
}

template <class Real>
Status FingertipKinematics<Real>::fingertips_batch(std::span<const Real> q, std::span<Real> fingertips,
                                                   std::span<Status> statuses) const noexcept {
  const Model& model = *model_;
  const FingertipKernel<Real>& kernel = model.kernel;
  const std::size_t joints = model.joints, count = q.size() / joints, fingers = model.chains.size();
  if (q.size() != count * joints || fingertips.size() != count * 3 * fingers || !holds_statuses(statuses, count))
    return Status::wrong_size;
  const auto q_of = [&](std::size_t row) { return q.data() + row * joints; };
  const auto out_of = [&](std::size_t row) { return fingertips.data() + row * 3 * fingers; };
  return wide_rows(
      count, statuses,
      [&](std::size_t first, std::size_t rows) { return kernel.place && kernel.takes(q_of(first), rows * joints); },
      [&](std::size_t first, std::size_t rows) {
        kernel.place(model.chains.data(), fingers, q_of(first), joints, rows, out_of(first));
      },
      [&](std::size_t row) { return model.place_one(q_of(row), out_of(row)); });
}

template class FingertipKinematics<float>;
template class FingertipKinematics<double>;

}  // namespace uhas
