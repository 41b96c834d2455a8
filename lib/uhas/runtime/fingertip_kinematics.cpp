#include "uhas/runtime/fingertip_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/runtime/fingertip_chain_detail.hpp"

namespace uhas {

template <class Real>
struct FingertipKinematics<Real>::Model {
  std::vector<FingertipChain<Real>> chains;  // [finger]
  std::vector<int> independent;              // joints whose values are read
  std::size_t joints;

  explicit Model(const HandProfile& profile) : joints(profile.tree.joints.size()) {
    for (std::size_t f = 0; f < profile.fingers.size(); ++f)
      chains.push_back(compile_chain<Real>(profile, static_cast<int>(f)));
    for (std::size_t i = 0; i < joints; ++i)
      if (profile.tree.joints[i].mimic_master < 0) independent.push_back(static_cast<int>(i));
  }

  void place(const Real* q, Real* out) const noexcept {
    const auto turn = [](Real angle, Real& cosine, Real& sine) { cosine = std::cos(angle), sine = std::sin(angle); };
    for (const FingertipChain<Real>& chain : chains) {
      const Vector3<Real> p = place_fingertip<Real>(
          chain, [=](int joint) { return q[joint]; }, turn);
      out[0] = p.x, out[1] = p.y, out[2] = p.z;
      out += 3;
    }
  }
};

template <class Real>
FingertipKinematics<Real>::FingertipKinematics(const HandProfile& profile) {
  validate_profile(profile, "");
  model_ = std::make_shared<const Model>(profile);
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
  if (q.size() != model_->joints) return Status::wrong_size;
  return fingertips_batch(q, fingertips);
}

template <class Real>
Status FingertipKinematics<Real>::fingertips_batch(std::span<const Real> q, std::span<Real> fingertips) const noexcept {
  const Model& model = *model_;
  const std::size_t count = q.size() / model.joints, numbers = 3 * model.chains.size();
  if (q.size() != count * model.joints || fingertips.size() != count * numbers) return Status::wrong_size;
  for (std::size_t n = 0; n < count; ++n)
    if (!std::ranges::all_of(model.independent, [&](int i) { return std::isfinite(q[n * model.joints + i]); }))
      return Status::non_finite_input;
  for (std::size_t n = 0; n < count; ++n) model.place(&q[n * model.joints], &fingertips[n * numbers]);
  return Status::ok;
}

template class FingertipKinematics<float>;
template class FingertipKinematics<double>;

}  // namespace uhas
