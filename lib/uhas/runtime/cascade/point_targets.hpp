// What is done point by point: the moments of the interpolated field (docs/method.md#the-interpolated-field), and the
// residual. Definitions of Cascade for plain numbers, one hand at a time.
#pragma once

#include "uhas/runtime/cascade/cascade.hpp"

namespace uhas {

template <class Num, class Visit>
void Cascade<Num, Visit>::average_planes(const Model& model) noexcept {
  for (std::size_t g = 0; g < group_planes_.size(); ++g)
    group_planes_[g] = mean_plane(planes, model.plane_groups.fingers[g], model.options.convention.held_toward_pole);
}

/// where a material point goes (docs/method.md#targets), and what closing leaves of it
template <class Num, class Visit>
typename Cascade<Num, Visit>::Target Cascade<Num, Visit>::target_of(const Model& model,
                                                                    const SolverPoint<Real>& point) const noexcept {
  // the deformation at the point: its finger's, or that between the planes on either side
  Displacement<Num> moved;
  if (model.options.field == FieldReading::finger) {
    const PlaneDeformation<Num>& plane = planes[point.finger];
    moved = {plane.delta_theta, plane.at(point.phi)};
  } else {
    moved = displacement_between(group_planes_[point.plane_before], group_planes_[point.plane_after], Num(point.blend),
                                 Num(point.phi));
  }
  // out along the point's direction, then about z of S
  const SinCos<Num> turn = sincos(model.azimuth_sign * moved.delta_theta);
  const Vector3<Num> t = max(point.rho + moved.radial.delta_r, Num(0)) * point.direction;
  return {{turn.cosine * t.x - turn.sine * t.y, turn.sine * t.x + turn.cosine * t.y, t.z},
          open_share<Num>(moved.radial, model.options.closing)};
}

/// the moments of every joint's own points in the interpolated field, where each has a displacement of its own
template <class Num, class Visit>
void Cascade<Num, Visit>::sum_points(const Model& model) noexcept {
  for (JointState& state : joints_) state.own = {};
  for (const SolverPoint<Real>& point : model.points) {
    const Target target = target_of(model, point);
    joints_[point.joint].own.add(point.weight, target.share, point.p, target.t);
  }
}

template <class Num, class Visit>
void Cascade<Num, Visit>::place_joints(const Model& model, std::span<const Num> q) noexcept {
  for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i].set(model.joints[i].value(q[i] / model.joints[i].unit));
  for (const SolverPart& part : model.parts) move_frames(model, part.tree);
}

template <class Num, class Visit>
SquaredErrors Cascade<Num, Visit>::squared_errors(const Model& model) const noexcept {
  SquaredErrors errors;
  for (const SolverPoint<Real>& point : model.points) {
    const Target target = target_of(model, point);
    const Vector3<Real> error = joints_[point.joint].T_S_moved * point.p - target.t;
    const double w = double(point.weight) * double(target.share);
    errors.sum += w * double(dot(error, error));
    errors.weight += w;
  }
  return errors;
}

}  // namespace uhas
