// Joint angles and their derivatives with respect to the numbers of the action (docs/method.md#derivatives).
//
//   uhas::DifferentiableSolver<double> solver(uhas::read_profile("hand.h5"));
//   std::vector<double> q(solver.joint_count()), jacobian(q.size() * action.size());
//   uhas::Status status = solver.solve_with_jacobian({.values = action}, q, jacobian);
//
// Constructing may throw and allocates; solving does neither, takes no lock and reads no clock.
#pragma once

#include <memory>
#include <span>

#include "uhas/base/export.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// Solves one hand and differentiates the solve. Copies share the constant model and have scratch memory of their own:
/// give each thread its copy.
template <class Real>
class UHAS_API DifferentiableSolver {
 public:
  /// Throws Error: as CascadeSolver; invalid_option for the rule `contact`, whose joints jump, and for the reading
  /// `field`.
  explicit DifferentiableSolver(const HandProfile& profile, const SolveOptions& options = {});
  DifferentiableSolver(const DifferentiableSolver& other);
  DifferentiableSolver& operator=(const DifferentiableSolver& other);
  DifferentiableSolver(DifferentiableSolver&&) noexcept;
  DifferentiableSolver& operator=(DifferentiableSolver&&) noexcept;
  ~DifferentiableSolver();

  int joint_count() const noexcept;  ///< length of q: every joint of the profile, mimic followers included

  /// What CascadeSolver::solve gives, bit for bit, and d q / d action.
  /// @param jacobian  [joint_count()][5 + 5 V] rad or m, a unit of the action's number (normalised ones: a unit of those).
  ///                  Exact, not by differences. A solve has kinks where something is held at a bound: there it is the
  ///                  derivative of the side that the solve takes. It is 0 of a joint that is held at a limit, and of a
  ///                  number that is beyond its bound or that no finger reads
  /// On any status but ok the outputs are untouched.
  Status solve_with_jacobian(const Action<Real>& action, std::span<Real> q, std::span<Real> jacobian) noexcept;

 private:
  struct UHAS_PRIVATE Scratch;
  std::shared_ptr<const SolverModel<Real>> model_;
  std::unique_ptr<Scratch> scratch_;
};

extern template class DifferentiableSolver<float>;
extern template class DifferentiableSolver<double>;

}  // namespace uhas
