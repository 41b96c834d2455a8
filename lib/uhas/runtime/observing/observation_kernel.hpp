// The observation's arithmetic, one source for one hand and for a hand a lane.
#pragma once

#include <cstddef>
#include <vector>

#include "uhas/runtime/lanes/lane_math.hpp"
#include "uhas/runtime/lanes/lane_rows.hpp"
#include "uhas/runtime/observation.hpp"

namespace uhas {

/// A profile in one number type and sphere radii, every joint's frame turned so that its axis is z.
template <class Real>
struct ObservationModel {
  struct ModelJoint {
    int parent;  ///< -1 = S itself
    bool prismatic;
    RigidTransform<Real> T_parent_joint;
    int source;          ///< the independent joint it follows: itself, or the master it mimics
    Real ratio, offset;  ///< motion = ratio * q[source] + offset, in rad or radii
  };
  struct CarriedVector {
    int joint;
    Vector3<Real> v;  ///< a point (radii) or a direction in the joint's frame
  };

  std::vector<ModelJoint> joints;
  std::vector<CarriedVector> points;  ///< [slot][point]
  std::vector<CarriedVector> pads;    ///< [slot], or empty
  Real mirror;                        ///< factor of y of positions, and of x and z of angular velocities
  int size;                           ///< numbers of an observation
};

/// One walk from the palm outward. Carrying velocities along gives each body the sum that a Jacobian times qd
/// would, without the Jacobian: a joint adds its own rate about or along its axis to what its parent has at
/// the joint's origin.
/// @param q, qd   [joints] Num
/// @param turn_of  called as turn_of(angle): its SinCos
template <class Num, class Real, class TurnOf>
void move_bodies(const ObservationModel<Real>& model, const Num* q, const Num* qd, TurnOf turn_of,
                 ObservedBody<Num>* bodies) {
  const ObservedBody<Num> palm{};
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const auto& joint = model.joints[i];
    const Num ratio(joint.ratio), motion = ratio * q[joint.source] + Num(joint.offset), rate = ratio * qd[joint.source];
    const ObservedBody<Num>& parent = joint.parent < 0 ? palm : bodies[joint.parent];
    ObservedBody<Num>& body = bodies[i];
    body.T = parent.T * joint.T_parent_joint.template cast<Num>();
    const Vector3<Num> axis = body.T.rotation.column(2);
    if (joint.prismatic) {
      body.T.translation += motion * axis;
    } else {
      const SinCos<Num> turned = turn_of(motion);
      for (int row = 0; row < 9; row += 3) {
        const Num x = body.T.rotation.m[row], y = body.T.rotation.m[row + 1];
        body.T.rotation.m[row] = turned.cosine * x + turned.sine * y;
        body.T.rotation.m[row + 1] = turned.cosine * y - turned.sine * x;
      }
    }
    body.linear = parent.linear + cross(parent.angular, body.T.translation - parent.T.translation);
    body.angular = parent.angular;
    (joint.prismatic ? body.linear : body.angular) += rate * axis;
  }
}

/// The observation of moved bodies. @param out  [model.size]
template <class Num, class Real>
void write_observation(const ObservationModel<Real>& model, const ObservedBody<Num>* bodies, Num* out) {
  const Num m(model.mirror);
  const auto put = [&](Num x, Num y, Num z) { out[0] = x, out[1] = y, out[2] = z, out += 3; };
  for (const auto& point : model.points) {
    const ObservedBody<Num>& body = bodies[point.joint];
    const Vector3<Num> arm = body.T.rotation * point.v.template cast<Num>(), p = body.T.translation + arm;
    const Vector3<Num> velocity = body.linear + cross(body.angular, arm);
    put(p.x, m * p.y, p.z);
    put(velocity.x, m * velocity.y, velocity.z);
    put(m * body.angular.x, body.angular.y, m * body.angular.z);
  }
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
