// A hand solved by the cascade alone, part by part and point by point: what walks are compared with.
#pragma once

#include <vector>

#include "uhas/runtime/cascade/cascade_kernel.hpp"
#include "uhas/runtime/cascade/contact_rule.hpp"
#include "uhas/runtime/cascade/point_targets.hpp"

namespace uhas::test {

template <class Real>
class PlainCascade {
 public:
  explicit PlainCascade(const HandProfile& profile, const SolveOptions& options = {})
      : model_(compile_solver_model<Real>(profile, options)),
        cascade_(*model_),
        q(profile.tree.joints.size()),
        at_limit(q.size()),
        closed(q.size()) {}

  /// @param action  one that a solver takes
  void solve(const Action<Real>& action) {
    model_->decoder.decode(model_->decoder.numbers_of(action), cascade_.planes.data());
    cascade_.begin(*model_);
    for (const SolverPart& part : model_->parts) cascade_.run(*model_, part);
    for (int i = 0; i < static_cast<int>(q.size()); ++i) {
      q[i] = model_->joints[i].in_profile_units(cascade_.q(i));
      at_limit[i] = cascade_.at_limit(i), closed[i] = cascade_.closed(i);
    }
  }

 private:
  std::shared_ptr<const SolverModel<Real>> model_;
  Cascade<Real, VisitInTurn> cascade_;

 public:
  std::vector<Real> q;                         ///< [joint] rad, m
  std::vector<std::uint8_t> at_limit, closed;  ///< [joint]
};

}  // namespace uhas::test
