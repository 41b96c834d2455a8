// Solves actions, and takes back those whose solution is in self-collision.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "uhas/collision/self_collision.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// How far toward an action a hand can go.
struct CollisionFreeSolution {
  Status status = Status::ok;
  /// In [0, 1]: the solution is that of the deformation scaled by this; 1 = as asked for. Empty when the undeformed
  /// hand collides too: the solution is that of the action as asked for.
  std::optional<double> scale;
  std::vector<double> values;  ///< numbers of the action that was solved
};

/// An action whose solution collides is scaled toward the undeformed sphere. The way is walked from there in 32 equal
/// steps up to the first that collides; that step is then halved ten times, so that a scale greater by 1/32768 is
/// known to collide.
///
/// The solution is free, and so are those at all whole steps below its scale. What lies between steps is not looked at,
/// nor is the way from any other pose; and an action whose own solution is free is kept, whatever lies before it.
class CollisionFreeSolver {
 public:
  /// `collision`: of the same hand; it must outlive the solver. Throws Error as CascadeSolver.
  CollisionFreeSolver(const HandProfile& profile, const SolveOptions& options, const SelfCollision& collision);
  CollisionFreeSolver(CollisionFreeSolver&&) noexcept;
  ~CollisionFreeSolver();

  /// As CascadeSolver::solve; `report` is of the solution. On any status but ok the output is untouched.
  CollisionFreeSolution solve(const Action<double>& action, std::span<double> q, SolveReport& report);

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

}  // namespace uhas
