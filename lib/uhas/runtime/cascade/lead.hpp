// How far a joint goes ahead of its own fit, because the joints further out have yet to move.
//
// The cascade fits a joint while its children still stand at their start. They will move too, and then the fit is no
// longer the best. To first order all moves are known beforehand: at rest every point is at its target, so that a small
// action u (the displacements at two polar angles) moves the joints of the best fit by K u, with the normal equations H
// K = G of J K u = dt/du u. A joint's own fit, held (cascade_kernel.hpp) and with decayed weights, moves it by
// (G' u - sum H'_p K_p u) / (H' + h), p = its parents. The difference is its lead, so that one pass ends at the best
// fit to first order in u.
#pragma once

#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {

/// Sets `lead` of every turning joint that is an unknown by itself and moves one finger; the others keep 0.
/// @param model  everything but the leads
template <class Real>
void set_leads(SolverModel<Real>& model);

}  // namespace uhas
