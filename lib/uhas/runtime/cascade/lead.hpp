// How far a joint goes ahead of its own fit, because the joints further out have yet to move (docs/method.md#lead).
//
// The cascade fits a joint while its children still stand at their start. They will move too, and then the fit is no
// longer the best. To first order all moves are known beforehand: at rest every point is at its target, so that a small
// action u (the displacements at two polar angles) moves the joints of the best fit by K u, with the normal equations
// H K = G of J K u = dt/du u. A joint's own fit, held (docs/method.md#hold) and with decayed weights, moves it by
// (G' u - sum H'_p K_p u) / (H' + h), p = its parents. The difference is its lead, so that one pass ends at the best
// fit to first order in u.
#pragma once

#include <vector>

#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {

/// What the first pass of a solve begins with.
template <class Real>
struct FirstPass {
  const std::vector<SolverJoint<Real>>& joints;
  const std::vector<SolverStart<Real>>& starts;
  const std::vector<SolverStep>& steps;
  const std::vector<SolverPoint<Real>>& points;
  Real decay;
  bool held_toward_pole;  ///< of the convention
};

/// [joint] the lead of every turning joint that is an unknown by itself and moves one finger; 0 of the others.
template <class Real>
std::vector<SolverLead<Real>> compile_leads(const FirstPass<Real>& pass, std::size_t finger_count);

}  // namespace uhas
