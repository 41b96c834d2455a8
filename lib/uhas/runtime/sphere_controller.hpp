// The sphere controller (paper, section 3.4 'Sphere Controller'): at every control period an action becomes the joint
// targets of the low-level controller, in steps that the hand can follow.
//
//   uhas::SphereController<double> controller(profile, {.time_constant = 0.05});
//   std::vector<double> targets(controller.joint_count());
//   controller.reset(q_measured, targets);
//   for (;;) uhas::Status status = controller.update({.values = action}, dt, targets);
//
// The targets are all of a hand's state and the caller's, so one controller serves any number of hands in turn.
// Each update moves them from where they are toward the solution of the action:
//
//   goal     solve(action), held in the middle `range_scale` of each joint's range
//   step     (1 - exp(-dt / time_constant)) (goal - target): first-order smoothing, exact for any sequence of dt
//   target   += step, held within +- velocity_scale * velocity limit * dt
//
// Mimic followers keep their relation to their master at every update; a group of them is as slow as
// its slowest member.
//
// Constructing may throw and allocates; updating does neither, takes no lock and reads no clock.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "uhas/base/export.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

struct SphereControllerOptions {
  double velocity_scale = 1;  ///< > 0: share of the URDF's velocity limits that targets may use. A joint that states no
                              ///< limit is bounded by its range and by the smoothing alone
  double range_scale = 1;     ///< (0, 1]: share of each joint's range, about its middle, that targets are led to
  double time_constant = 0;   ///< s, >= 0: of the smoothing; 0 = none
  SolveOptions solve{};
};

/// Controls hands of one kind. Copies share the constant model and have scratch memory of their own: give each
/// thread its copy.
template <class Real>
class UHAS_API SphereController {
 public:
  /// Throws Error: as CascadeSolver; invalid_option for an option out of its range.
  explicit SphereController(const HandProfile& profile, const SphereControllerOptions& options = {});

  /// Length of q and of the targets: every joint of the profile, mimic followers included.
  int joint_count() const noexcept;

  /// Begins at a posture, usually the measured one: held within the joints' limits, followers where their
  /// masters put them.
  /// @param q        [joint_count()] rad (m for sliding joints), in the profile's joint order
  /// @param targets  [joint_count()] out; untouched on any status but ok
  Status reset(std::span<const Real> q, std::span<Real> targets) const noexcept;

  /// One control period.
  /// @param action   as CascadeSolver takes it
  /// @param dt       s, since the last update; > 0 and finite, else Status::invalid_period
  /// @param targets  [joint_count()] in: those of `reset` or of the last update; out: the next ones. Held (untouched)
  ///                 on any status but ok. Within the joints' limits; the elements of followers are not read
  Status update(const Action<Real>& action, Real dt, std::span<Real> targets) noexcept;

  /// The same toward a solution that is there already: a row of a BatchSolver's, when there are many hands.
  /// @param solution  [joint_count()] rad (m for sliding joints)
  Status approach(std::span<const Real> solution, Real dt, std::span<Real> targets) const noexcept;

 private:
  /// How a joint may move.
  struct Motion {
    Real lower, upper;            // the joint's limits
    Real goal_lower, goal_upper;  // the share of them that goals are held in
    Real velocity;                // largest speed (rad/s, m/s); infinite when no member of the group states a limit
    int master;                   // the joint it follows; -1 = independent
    Real multiplier, offset;      // of a follower
  };
  using Motions = std::vector<Motion>;

  UHAS_PRIVATE Status check(std::span<const Real> q) const noexcept;
  UHAS_PRIVATE void step(std::span<const Real> solution, Real dt, std::span<Real> targets) const noexcept;
  UHAS_PRIVATE void follow(std::span<Real> targets) const noexcept;

  CascadeSolver<Real> solver_;
  std::shared_ptr<const Motions> motions_;  // [joint]
  Real time_constant_;
  std::vector<Real> goal_;  // [joint]
};

extern template class SphereController<float>;
extern template class SphereController<double>;

}  // namespace uhas
