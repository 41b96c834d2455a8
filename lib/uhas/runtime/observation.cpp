#include "uhas/runtime/observation.hpp"

#include <cmath>

#include "uhas/kinematics/axis_frame.hpp"
#include "uhas/runtime/observing/observation_kernel.hpp"

namespace uhas {
namespace {

/// The finger each slot shows: its owner; of several owners the one that has been shown least.
std::array<int, kSlotCount> fingers_in_slots(const HandProfile& profile) {
  std::array<int, kSlotCount> fingers{};
  std::vector<int> times_shown(profile.fingers.size(), 0);
  for (int slot = 0; slot < kSlotCount; ++slot) {
    int shown = -1;
    for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f)
      if (profile.fingers[f].slots[slot] && (shown < 0 || times_shown[f] < times_shown[shown])) shown = f;
    ++times_shown[shown];
    fingers[slot] = shown;
  }
  return fingers;
}

}  // namespace

template <class Real>
struct Observer<Real>::Model : ObservationModel<Real> {
  using typename ObservationModel<Real>::ModelJoint;
  using typename ObservationModel<Real>::CarriedVector;
  using ObservationModel<Real>::joints, ObservationModel<Real>::points, ObservationModel<Real>::pads,
      ObservationModel<Real>::size;
  ObservationKernel<Real> kernel{};  // empty for one hand after the other

  Model(const HandProfile& profile, const ObservationOptions& options, InstructionSet set) {
    this->mirror = profile.mirrored ? Real(-1) : Real(1);
    for (int i = 0; i < static_cast<int>(profile.tree.joints.size()); ++i) joints.push_back(compile_joint(profile, i));
    const auto carried = [&](int joint, Vector3d v) -> CarriedVector {
      return {joint, (axis_frame(profile.tree.joints[joint]).transposed() * v).cast<Real>()};
    };
    for (int f : fingers_in_slots(profile)) {
      const auto along = finger_points(profile, f);
      for (int k = 0; k < kFingerPoints; ++k)
        if (options.points[k]) points.push_back(carried(along[k].joint, along[k].p_joint / profile.radius));
      if (!options.pad_directions) continue;
      const ProfileFinger& finger = profile.fingers[f];
      const ProfileLink& tip = profile.links[finger.tip_link];
      pads.push_back(carried(tip.joint, tip.T_joint_link.rotation * finger.pad_normal_link));
    }
    size = static_cast<int>(kPointNumbers * points.size() + 3 * pads.size());
    kernel = kernel_for(set);
  }

  ObservationKernel<Real> kernel_for(InstructionSet set) const {
    if (set == InstructionSet::scalar || joints.size() > kObservedJoints) return {};
#ifdef UHAS_HAS_AVX2_SOURCES
    if (set == InstructionSet::avx2 && is_available(set)) return observation_kernel_avx2<Real>();
#endif
    return observation_kernel_baseline<Real>();
  }

  static ModelJoint compile_joint(const HandProfile& profile, int index) {
    const Joint& joint = profile.tree.joints[index];
    const RigidTransformd T_base_parent =
        joint.parent < 0 ? profile.T_palm_sphere.inverse()
                         : RigidTransformd{axis_frame(profile.tree.joints[joint.parent]).transposed(), {}};
    RigidTransformd T = T_base_parent * joint.T_parent_joint;
    T.rotation = T.rotation * axis_frame(joint);
    T.translation = T.translation / profile.radius;

    const bool prismatic = joint.kind == JointKind::prismatic, follows = joint.mimic_master >= 0;
    const double unit = prismatic ? profile.radius : 1.0;
    return {joint.parent,
            prismatic,
            T.cast<Real>(),
            follows ? joint.mimic_master : index,
            static_cast<Real>((follows ? joint.mimic_multiplier : 1.0) / unit),
            static_cast<Real>((follows ? joint.mimic_offset : 0.0) / unit)};
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
