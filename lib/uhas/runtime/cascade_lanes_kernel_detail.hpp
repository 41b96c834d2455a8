// The one source of every CascadeLanes.
#pragma once

#include "uhas/runtime/cascade_kernel_detail.hpp"
#include "uhas/runtime/cascade_lanes_detail.hpp"

namespace uhas {

template <class Num, class Wide>
struct CascadeLanesOf {
  using Real = LaneReal<Num>;
  using Scratch = Cascade<Num, Wide>;
  static constexpr int width = LaneTraits<Num>::width;
  static_assert(width <= kMostLanes);

  static void* make(const SolverModel<Real>& model) { return new Scratch(model); }
  static void destroy(void* scratch) { delete static_cast<Scratch*>(scratch); }

  static void solve(void* scratch, const SolverModel<Real>& model, const ActionRows<Real>& rows) {
    Scratch& cascade = *static_cast<Scratch*>(scratch);
    Num values[kSlotCount * (1 + kMaxDrivingVectors)], phi[kSlotCount * kMaxDrivingVectors];
    for (int i = 0; i < kSlotCount * (1 + rows.vectors); ++i)
      for (int l = 0; l < width; ++l) set_lane(values[i], l, rows.values[l][i]);
    for (int i = 0; i < rows.angles; ++i)
      for (int l = 0; l < width; ++l) set_lane(phi[i], l, rows.phi[l][i]);
    const ActionNumbers<Num> numbers{.values = values,
                                     .phi = phi,
                                     .vectors = rows.vectors,
                                     .angles = rows.angles,
                                     .common_phi = rows.common_phi || width == 1,
                                     .normalized = rows.normalized};
    model.decoder.decode(numbers, cascade.planes.data());
    cascade.run(model);
    for (int i = 0; i < static_cast<int>(model.joints.size()); ++i) {
      const Num q = cascade.q(i) * Num(model.joints[i].unit);
      for (int l = 0; l < rows.count; ++l) rows.q[l][i] = lane(q, l);
    }
  }

  static CascadeLanes<Real> functions() { return {width, &make, &destroy, &solve}; }
};

}  // namespace uhas
