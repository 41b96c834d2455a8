// The observation's arithmetic, one source for one hand and for a hand a lane.
#pragma once

#include <cstddef>

#include "uhas/runtime/lanes/lane_math.hpp"
#include "uhas/runtime/lanes/lane_rows.hpp"
#include "uhas/runtime/observing/observation_model.hpp"

namespace uhas {

/// One walk from the palm outward (docs/method.md#observation). Carrying velocities along gives each body the sum that
/// a Jacobian times qd would, without the Jacobian.
/// @param q, qd   [joints] Num
/// @param turn_of  called as turn_of(angle): its SinCos
template <class Num, class Real, class TurnOf>
void move_bodies(const ObservationModel<Real>& model, const Num* q, const Num* qd, TurnOf turn_of,
                 ObservedBody<Num>* bodies) {
  const ObservedBody<Num> palm{};
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const CompiledJoint<Real>& joint = model.joints[i];
    const ObservedBody<Num>& parent = joint.parent < 0 ? palm : bodies[joint.parent];
    ObservedBody<Num>& body = bodies[i];

    // how far the joint moves, and how fast, as the joint that decides says
    JointValue<Num> value{joint.motion_at(q[joint.source]), Num(1), Num(0)};
    const Num rate = Num(joint.ratio) * qd[joint.source];
    if (!joint.prismatic) {
      const SinCos<Num> turned = turn_of(value.q);
      value.cosine = turned.cosine, value.sine = turned.sine;
    }

    // its frame: the parent's, the way to the joint, the motion
    body.T = joint.moved(parent.T * joint.T_parent_joint.template cast<Num>(), value);

    // its velocities: what the parent has at the joint's origin, and the joint's own rate about or along its axis
    body.linear = parent.linear + cross(parent.angular, body.T.translation - parent.T.translation);
    body.angular = parent.angular;
    (joint.prismatic ? body.linear : body.angular) += rate * body.T.rotation.column(2);
  }
}

/// The observation of moved bodies. A mirrored hand reports its mirror image: y of positions and velocities, x and z of
/// angular velocities change their sign.
/// @param out  [model.size]
template <class Num, class Real>
void write_observation(const ObservationModel<Real>& model, const ObservedBody<Num>* bodies, Num* out) {
  const Num m(model.mirror);
  const auto put = [&](Num x, Num y, Num z) { out[0] = x, out[1] = y, out[2] = z, out += 3; };

  // of each point where it is, and what its body's velocities give it
  for (const auto& point : model.points) {
    const ObservedBody<Num>& body = bodies[point.joint];
    const Vector3<Num> arm = body.T.rotation * point.v.template cast<Num>(), p = body.T.translation + arm;
    const Vector3<Num> velocity = body.linear + cross(body.angular, arm);
    put(p.x, m * p.y, p.z);
    put(velocity.x, m * velocity.y, velocity.z);
    put(m * body.angular.x, body.angular.y, m * body.angular.z);
  }

  // of each pad where it faces
  for (const auto& pad : model.pads) {
    const Vector3<Num> direction = bodies[pad.joint].T.rotation * pad.v.template cast<Num>();
    put(direction.x, m * direction.y, direction.z);
  }
}

/// The largest hand and observation that wide kernels take.
inline constexpr std::size_t kObservedJoints = 64, kObservedNumbers = 5 * (7 * 9 + 3);

/// What a wide kernel does, behind a boundary of plain pointers.
template <class Real>
struct ObservationKernel {
  /// Whether each of the numbers [count] is one that `observe` takes.
  bool (*takes)(const Real* numbers, std::size_t count);
  /// @param q, qd         [hands][joints]
  /// @param observations  [hands][model.size]
  void (*observe)(const ObservationModel<Real>& model, const Real* q, const Real* qd, std::size_t hands,
                  Real* observations);
};

template <class Real>
ObservationKernel<Real> observation_kernel_baseline();
template <class Real>
ObservationKernel<Real> observation_kernel_avx2();

template <class Num>
struct ObservationLanes {
  using Real = LaneReal<Num>;

  static void observe(const ObservationModel<Real>& model, const Real* q, const Real* qd, std::size_t hands,
                      Real* observations) {
    constexpr std::size_t width = LaneTraits<Num>::width;
    const std::size_t joints = model.joints.size(), size = std::size_t(model.size);
    Num values[kObservedJoints], rates[kObservedJoints], out[kObservedNumbers];
    ObservedBody<Num> bodies[kObservedJoints];
    for (std::size_t first = 0; first < hands; first += width) {
      // a hand a lane; lanes past the last hand repeat it
      const std::size_t filled = hands - first < width ? hands - first : width;
      load_rows(q + first * joints, joints, filled, joints, values);
      load_rows(qd + first * joints, joints, filled, joints, rates);
      move_bodies(
          model, values, rates, [](Num angle) { return sincos(angle); }, bodies);
      write_observation(model, bodies, out);
      store_rows(out, filled, size, size, observations + first * size);
    }
  }

  static ObservationKernel<Real> kernel() { return {&LaneNumbers<Num>::takes, &observe}; }
};

}  // namespace uhas
