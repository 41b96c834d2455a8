// The one source of every CascadeLanes. A finger that stands alone is the unit: whole fingers of as many hands as there are
// lanes walk together, and so do fingers with points that fade; all else goes through the cascade, a hand a lane. Which way
// a finger goes depends on its own hand alone, and so do its bits.
#pragma once

#include <vector>

#include "uhas/runtime/lanes/cascade_lanes.hpp"
#include "uhas/runtime/lanes/finger_queue.hpp"
#include "uhas/runtime/lanes/hand_walk.hpp"

namespace uhas {

template <class Num>
class CascadeLanesOf {
 public:
  using Real = LaneReal<Num>;
  using Model = SolverModel<Real>;
  using Finger = AffineFinger<Real>;
  using Rows = FingerRows<Num>;
  static constexpr int width = LaneTraits<Num>::width;
  static_assert(width <= kMostLanes);

  static CascadeLanes<Real> functions() { return {width, &make, &destroy, &take, &finish}; }

 private:
  explicit CascadeLanesOf(const Model& model)
      : model_(model), whole_(model.lone_fingers.size()), faded_(whole_.size()), cascade_(model) {}

  static void* make(const Model& model) { return new CascadeLanesOf(model); }
  static void destroy(void* scratch) { delete static_cast<CascadeLanesOf*>(scratch); }
  static void take(void* scratch, const ActionRows<Real>& rows) { static_cast<CascadeLanesOf*>(scratch)->take(rows); }
  static void finish(void* scratch) { static_cast<CascadeLanesOf*>(scratch)->finish(); }

  /// Number by number, a row a lane.
  static void gather(const Real* const* rows, int count, Num* numbers) {
    for (int i = 0; i < count; ++i)
      for (int l = 0; l < width; ++l) set_lane(numbers[i], l, rows[l][i]);
  }

  void take(const ActionRows<Real>& rows) {
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
    vectors_ = rows.vectors, angles_ = rows.angles, common_phi_ = numbers.common_phi;
    for (std::size_t n = 0; n < whole_.size(); ++n) take_finger(n, numbers, rows);
    if (!model_.other_parts.empty()) solve_others(numbers, rows);
  }

  void take_finger(std::size_t n, const ActionNumbers<Num>& numbers, const ActionRows<Real>& rows) {
    const Finger& finger = model_.lone_fingers[n].fingers.front();
    Rows hands{};
    hands.count = rows.count;
    hands.delta_theta = model_.decoder.decode_numbers(numbers, finger.finger, hands.delta_r.data());
    if (angles_ != 0) model_.decoder.decode_angles(numbers, finger.finger, hands.phi.data());
    std::copy_n(rows.q, width, hands.q.begin());
    // whole ones at once if all are, else as soon as there are enough; so those that fade
    Num lowest = hands.delta_r[0];
    for (int j = 1; j < vectors_; ++j) lowest = min(lowest, hands.delta_r[j]);
    const MaskOf<Num> whole = angles_ == 0 ? lowest >= Num(finger.lowest) : MaskOf<Num>(false);
    if (all(whole)) return walk_whole(n, hands);
    for (int l = 0; l < hands.count; ++l) {
      const bool is_whole = lane(whole, l);
      Rows& waiting = is_whole ? whole_[n] : faded_[n];
      waiting.push(hands, l, vectors_);
      if (waiting.count == width) is_whole ? walk_whole(n, waiting) : walk_faded(n, waiting);
    }
  }

  /// Those that still wait.
  void finish() {
    for (std::size_t n = 0; n < whole_.size(); ++n) {
      if (whole_[n].count > 0) walk_whole(n, whole_[n]);
      if (faded_[n].count > 0) walk_faded(n, faded_[n]);
    }
  }

  [[gnu::flatten]] void walk_whole(std::size_t n, Rows& hands) {
    const AffineBundle<Real>& bundle = model_.lone_fingers[n];
    PlaneDeformation<Num> plane;
    plane.vectors = vectors_;
    plane.delta_theta = hands.delta_theta;
    plane.delta_r = hands.delta_r;
    for (int u = 0; u < kLeadInputs; ++u)
      plane.lead[u] = model_.decoder.default_lead(vectors_, u, hands.delta_r.data());
    walk_whole_finger(bundle, walk_input(model_, bundle.fingers.front(), plane),
                      [&](int joint, const Num& q) { store_joint(hands, joint, q); });
    end(bundle.fingers.front(), hands);
  }

  [[gnu::flatten]] void walk_faded(std::size_t n, Rows& hands) {
    const AffineBundle<Real>& bundle = model_.lone_fingers[n];
    PlaneDeformation<Num>& plane = cascade_.planes[bundle.fingers.front().finger];
    plane.delta_theta = hands.delta_theta;
    plane.delta_r = hands.delta_r;
    plane.phi = hands.phi;
    model_.decoder.complete(vectors_, angles_ == 0, common_phi_, plane);
    walk_faded_finger(model_, bundle, walk_input(model_, bundle.fingers.front(), plane), cascade_,
                      [&](int joint, const Num& q) { store_joint(hands, joint, q); });
    end(bundle.fingers.front(), hands);
  }

  void solve_others(const ActionNumbers<Num>& numbers, const ActionRows<Real>& rows) {
    model_.decoder.decode(numbers, cascade_.planes.data());
    for (int n : model_.other_parts) {
      cascade_.run(model_, model_.parts[n]);
      for (const ScopedJoint& s : model_.parts[n].tree) {
        const Num q = model_.joints[s.joint].in_profile_units(cascade_.q(s.joint));
        for (int l = 0; l < rows.count; ++l) rows.q[l][s.joint] = lane(q, l);
      }
    }
  }

  /// A turn, which has the same unit everywhere.
  static void store_joint(const Rows& hands, int joint, const Num& q) {
    for (int l = 0; l < hands.count; ++l) hands.q[l][joint] = lane(q, l);
  }

  /// The joints that no step turns; no hand waits from here on.
  void end(const Finger& finger, Rows& hands) const {
    for (const auto& [joint, value] : finger.others)
      for (int l = 0; l < hands.count; ++l) hands.q[l][joint] = model_.joints[joint].in_profile_units(value);
    hands.count = 0;
  }

  const Model& model_;
  std::vector<Rows> whole_, faded_;  // [of the model's lone fingers] that wait
  Cascade<Num, VisitInTurn> cascade_;
  int vectors_ = 0, angles_ = 0;  // of the present batch
  bool common_phi_ = true;
};

}  // namespace uhas
