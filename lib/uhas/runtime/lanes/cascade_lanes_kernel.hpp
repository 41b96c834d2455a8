// The one source of every CascadeLanes.
#pragma once

#include "uhas/runtime/cascade/cascade_kernel.hpp"
#include "uhas/runtime/lanes/cascade_lanes.hpp"

namespace uhas {

template <class Num>
struct CascadeLanesOf {
  using Real = LaneReal<Num>;
  using Scratch = Cascade<Num, VisitInTurn>;
  static constexpr int width = LaneTraits<Num>::width;
  static_assert(width <= kMostLanes);

  /// Number by number, a row a lane.
  static void gather(const Real* const* rows, int count, Num* numbers) {
    for (int i = 0; i < count; ++i)
      for (int l = 0; l < width; ++l) set_lane(numbers[i], l, rows[l][i]);
  }

  static void* make(const SolverModel<Real>& model) { return new Scratch(model); }
  static void destroy(void* scratch) { delete static_cast<Scratch*>(scratch); }

  static void solve(void* scratch, const SolverModel<Real>& model, const ActionRows<Real>& rows) {
    Scratch& cascade = *static_cast<Scratch*>(scratch);
    // rows to lanes: number by number, a row a lane
    Num values[kSlotCount * (1 + kMaxDrivingVectors)], phi[kSlotCount * kMaxDrivingVectors];
    Num azimuth_offsets[kSlotCount], radial_bounds[2];
    const bool have_offsets = rows.azimuth_offsets[0] != nullptr, have_bounds = rows.radial_bounds[0] != nullptr;
    gather(rows.values, kSlotCount * (1 + rows.vectors), values);
    gather(rows.phi, rows.angles, phi);
    gather(rows.azimuth_offsets, have_offsets ? kSlotCount : 0, azimuth_offsets);
    gather(rows.radial_bounds, have_bounds ? 2 : 0, radial_bounds);
    const ActionNumbers<Num> numbers{.values = values,
                                     .phi = phi,
                                     .vectors = rows.vectors,
                                     .angles = rows.angles,
                                     .common_phi = rows.common_phi || width == 1,
                                     .normalized = rows.normalized,
                                     .azimuth_offsets = have_offsets ? azimuth_offsets : nullptr,
                                     .radial_bounds = have_bounds ? radial_bounds : nullptr};
    // as for one hand (cascade_solver.cpp), all lanes at once
    model.decoder.decode(numbers, cascade.planes.data());
    cascade.begin(model);
    for (const SolverPart& part : model.parts) cascade.run(model, part);
    // lanes to rows, in the profile's units
    for (int i = 0; i < static_cast<int>(model.joints.size()); ++i) {
      const Num q = model.joints[i].in_profile_units(cascade.q(i));
      for (int l = 0; l < rows.count; ++l) rows.q[l][i] = lane(q, l);
    }
  }

  static CascadeLanes<Real> functions() { return {width, &make, &destroy, &solve}; }
};

}  // namespace uhas
