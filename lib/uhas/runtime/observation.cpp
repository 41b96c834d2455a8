#include "uhas/runtime/observation.hpp"

#include <algorithm>
#include <cmath>

namespace uhas {
namespace {

/// The rotation whose z is the joint's axis. Frames turned by it make a joint's motion one in their first two columns.
Rotationd axis_frame(const Joint& joint) {
  const Vector3d z = normalized(joint.axis), x = any_orthogonal(z);
  return Rotationd::from_columns(x, cross(z, x), z);
}

/// R := R * (rotation about z).
template <class Real>
void turn_about_z(Rotation<Real>& R, Real angle) {
  const Real c = std::cos(angle), s = std::sin(angle);
  for (int row = 0; row < 9; row += 3) {
    const Real x = R.m[row], y = R.m[row + 1];
    R.m[row] = c * x + s * y;
    R.m[row + 1] = c * y - s * x;
  }
}

template <class Real>
Real* put(Vector3<Real> a, Real* out) {
  out[0] = a.x, out[1] = a.y, out[2] = a.z;
  return out + 3;
}

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

// The profile in one number type and sphere radii, every joint's frame turned so that its axis is z.
template <class Real>
struct Observer<Real>::Model {
  struct ModelJoint {
    int parent;  // -1 = S itself
    bool prismatic;
    RigidTransform<Real> T_parent_joint;
    int source;          // the independent joint it follows: itself, or the master it mimics
    Real ratio, offset;  // motion = ratio * q[source] + offset, in rad or radii
  };
  struct CarriedVector {
    int joint;
    Vector3<Real> v;  // a point (radii) or a direction in the joint's frame
  };

  std::vector<ModelJoint> joints;
  std::vector<CarriedVector> points;  // [slot][point]
  std::vector<CarriedVector> pads;    // [slot], or empty
  Real mirror;                        // factor of y of positions, and of x and z of angular velocities
  int size;

  Model(const HandProfile& profile, const ObservationOptions& options) : mirror(profile.mirrored ? Real(-1) : Real(1)) {
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
Observer<Real>::Observer(const HandProfile& profile, const ObservationOptions& options) {
  validate_profile(profile, "");
  model_ = std::make_shared<const Model>(profile, options);
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
  if (q.size() != bodies_.size()) return Status::wrong_size;
  return observe_batch(q, qd, observation);
}

template <class Real>
Status Observer<Real>::observe_batch(std::span<const Real> q, std::span<const Real> qd,
                                     std::span<Real> observations) noexcept {
  const std::size_t joints = bodies_.size(), count = q.size() / joints;
  if (q.size() != count * joints || qd.size() != q.size() || observations.size() != count * model_->size)
    return Status::wrong_size;
  for (std::size_t n = 0; n < count; ++n)
    if (!finite(&q[n * joints], &qd[n * joints])) return Status::non_finite_input;
  for (std::size_t n = 0; n < count; ++n) {
    move_bodies(&q[n * joints], &qd[n * joints]);
    write(observations.data() + n * model_->size);
  }
  return Status::ok;
}

template <class Real>
bool Observer<Real>::finite(const Real* q, const Real* qd) const noexcept {
  return std::ranges::all_of(model_->joints, [=](const auto& joint) {
    return std::isfinite(q[joint.source]) && std::isfinite(qd[joint.source]);
  });
}

// One walk from the palm outward. Carrying velocities along gives each body the sum that a Jacobian times qd would,
// without the Jacobian: a joint adds its own rate about or along its axis to what its parent has at the joint's origin.
template <class Real>
void Observer<Real>::move_bodies(const Real* q, const Real* qd) noexcept {
  static constexpr Body palm{};
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const auto& joint = model_->joints[i];
    const Real motion = joint.ratio * q[joint.source] + joint.offset, rate = joint.ratio * qd[joint.source];
    const Body& parent = joint.parent < 0 ? palm : bodies_[joint.parent];
    Body& body = bodies_[i];
    body.T = parent.T * joint.T_parent_joint;
    const Vector3<Real> axis = body.T.rotation.column(2);
    if (joint.prismatic)
      body.T.translation += motion * axis;
    else
      turn_about_z(body.T.rotation, motion);

    body.linear = parent.linear + cross(parent.angular, body.T.translation - parent.T.translation);
    body.angular = parent.angular;
    (joint.prismatic ? body.linear : body.angular) += rate * axis;
  }
}

template <class Real>
void Observer<Real>::write(Real* out) const noexcept {
  const Real m = model_->mirror;
  for (const auto& point : model_->points) {
    const Body& body = bodies_[point.joint];
    const Vector3<Real> arm = body.T.rotation * point.v, p = body.T.translation + arm;
    const Vector3<Real> velocity = body.linear + cross(body.angular, arm);
    out = put({p.x, m * p.y, p.z}, out);
    out = put({velocity.x, m * velocity.y, velocity.z}, out);
    out = put({m * body.angular.x, body.angular.y, m * body.angular.z}, out);
  }
  for (const auto& pad : model_->pads) {
    const Vector3<Real> direction = bodies_[pad.joint].T.rotation * pad.v;
    out = put({direction.x, m * direction.y, direction.z}, out);
  }
}

template class Observer<float>;
template class Observer<double>;

}  // namespace uhas
