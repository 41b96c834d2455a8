// The homogeneous observation (paper, 'Sphere Observation Space'; docs/method.md#observation): the same numbers for
// every hand.
//
//   uhas::Observer<float> observer(uhas::read_profile("hand.h5"));
//   std::vector<float> observation(observer.size());
//   uhas::Status status = observer.observe(q, qd, observation);
//
// Layout: [5 slots][P points][9], then, on request, [5 slots][3]. 90 numbers by default (P = 2), row-major.
//   slots    pinky, ring, middle, index, thumb; a finger that owns several slots stands in each of them
//   points   the chosen ones of the finger's seven, root to tip (finger_points.hpp)
//   [9]      position x y z (sphere radii), linear velocity x y z (radii/s), angular velocity x y z (rad/s)
//   [3]      pad direction: the outward normal of the fingertip's pad, unit
// All relative to the palm, in the sphere frame S. A mirrored hand reports its mirror image, as the canonical azimuth
// does: positions, linear velocities and pad directions (x, -y, z), angular velocities (-x, y, -z).
//
// Constructing may throw and allocates; observing does neither, takes no lock and reads no clock.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/base/export.hpp"
#include "uhas/base/rigid_transform.hpp"
#include "uhas/runtime/finger_points.hpp"
#include "uhas/runtime/instruction_set.hpp"

namespace uhas {

/// Numbers that an observation holds of one point.
inline constexpr int kPointNumbers = 9;

struct ObservationOptions {
  /// Which of a finger's points are observed, root to tip. Default: the fourth, half way, and the fingertip.
  std::array<bool, kFingerPoints> points{false, false, false, true, false, false, true};
  bool pad_directions = false;  ///< append each slot's pad direction
};

/// A joint's moved frame in S and how it moves, in sphere radii: scratch of an Observer.
template <class Num>
struct ObservedBody {
  RigidTransform<Num> T;
  Vector3<Num> linear, angular;  ///< velocity of the frame's origin, and of the frame
};

/// Observes one hand. Copies share the constant model and have scratch memory of their own: give each thread its copy.
template <class Real>
class UHAS_API Observer {
 public:
  /// Throws Error(invalid_profile) for a profile that `validate_profile` refuses.
  /// @param set  what batches use; when it is not available, the widest that is
  explicit Observer(const HandProfile& profile, const ObservationOptions& options = {},
                    InstructionSet set = widest_instruction_set());

  int joint_count() const noexcept;  ///< length of q and of qd: every joint of the profile, mimic followers included
  int size() const noexcept;         ///< numbers of one observation

  /// @param q            [joint_count()] rad, m for prismatic joints, in the profile's joint order
  /// @param qd           [joint_count()] rad/s, m/s
  /// @param observation  [size()] caller-owned; untouched on any status but ok
  /// The elements of mimic followers are not read: their motion follows from their masters', so that an observation
  /// depends on nothing but actuated joints. Values beyond the joints' limits are taken as they are.
  Status observe(std::span<const Real> q, std::span<const Real> qd, std::span<Real> observation) noexcept;

  /// The same for N hands of this kind, on the calling thread: q and qd [N][joint_count()] to observations [N][size()].
  /// Refuses row by row, as `Status` says; `statuses`: [N] or empty. A row's result does not depend on the others; it
  /// is that of a single call to within rounding, on every instruction set.
  Status observe_batch(std::span<const Real> q, std::span<const Real> qd, std::span<Real> observations,
                       std::span<Status> statuses = {}) noexcept;

 private:
  struct UHAS_PRIVATE Model;

  UHAS_PRIVATE Status observe_one(const Real* q, const Real* qd, Real* observation) noexcept;

  std::shared_ptr<const Model> model_;
  std::vector<ObservedBody<Real>> bodies_;  // [joint] scratch
};

extern template class Observer<float>;
extern template class Observer<double>;

}  // namespace uhas
