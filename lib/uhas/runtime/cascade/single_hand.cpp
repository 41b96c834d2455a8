#include "uhas/runtime/cascade/single_hand.hpp"

#include <algorithm>

#include "uhas/runtime/cascade/affine_walk.hpp"
#include "uhas/runtime/cascade/cascade_kernel.hpp"
#include "uhas/runtime/cascade/contact_rule.hpp"
#include "uhas/runtime/cascade/point_targets.hpp"
#include "uhas/runtime/instruction_set.hpp"
#include "uhas/runtime/lanes/cascade_lanes.hpp"

namespace uhas {
namespace {

/// As wide as `fingers` ask for. All give the same bits: which it is needs no name of its own, and the widest set of a
/// batch bounds it.
template <class Real>
FingerLanes<Real> lanes_for(std::size_t fingers) {
#ifdef UHAS_HAS_AVX2_SOURCES
  if (widest_instruction_set() == InstructionSet::avx2) {
#ifdef UHAS_HAS_AVX512_SOURCES
    const bool is_wide_enough = fingers <= std::size_t(finger_lanes_avx2<Real>().width);
    if (!is_wide_enough && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq"))
      return finger_lanes_avx512<Real>();
#endif
    return finger_lanes_avx2<Real>();
  }
#endif
  return finger_lanes_baseline<Real>();
}

}  // namespace

template <class Real>
SingleHand<Real>::SingleHand(const SolverModel<Real>& model)
    : model_(&model),
      lanes_(lanes_for<Real>(model.tips.size())),
      bundles_(std::make_shared<const std::vector<Bundle>>(make_bundles(model, lanes_.width))),
      cascade_(model, lanes_.visit),
      faded_(bundles_->size()) {
  std::size_t numbers = 0;
  for (const Bundle& bundle : *bundles_) numbers = bundle.first + bundle.constants.steps() * lanes_.width;
  q_.resize(numbers), at_limit_.resize(numbers), open_share_.resize(numbers), sums_.resize(kTurnSums * numbers);
}

template <class Real>
std::vector<typename SingleHand<Real>::Bundle> SingleHand<Real>::make_bundles(const SolverModel<Real>& model,
                                                                              int width) {
  std::vector<Bundle> bundles;
  int first = 0;
  for (AffineBundle<Real>& constants : bundle_fingers(model, width)) {
    Bundle bundle{std::move(constants), {}, first};
    const auto& fingers = bundle.constants.fingers;
    for (int l = 0; l < static_cast<int>(fingers.size()); ++l)
      for (int s = 0; s < bundle.constants.steps(); ++s)
        if (fingers[l].joints[s] >= 0) bundle.places.push_back({fingers[l].joints[s], s, l, s * width + l});
    first += bundle.constants.steps() * width;
    bundles.push_back(std::move(bundle));
  }
  return bundles;
}

template <class Real>
void SingleHand<Real>::solve(const ActionNumbers<Real>& action, std::span<Real> q) noexcept {
  for (std::size_t n = 0; n < bundles_->size(); ++n) solve_bundle(n, action, q);
  if (!model_->other_parts.empty()) solve_others(action, q);
}

template <class Real>
void SingleHand<Real>::solve_others(const ActionNumbers<Real>& action, std::span<Real> q) noexcept {
  // numbers to the deformation of each finger's plane, deformations to joint values, out in the profile's units
  model_->decoder.decode(action, cascade_.planes.data());
  cascade_.begin(*model_);
  for (int n : model_->other_parts) {
    cascade_.run(*model_, model_->parts[n]);
    for (const ScopedJoint& s : model_->parts[n].tree)
      q[s.joint] = model_->joints[s.joint].in_profile_units(cascade_.q(s.joint));
  }
}

template <class Real>
void SingleHand<Real>::solve_bundle(std::size_t index, const ActionNumbers<Real>& action, std::span<Real> q) noexcept {
  const Bundle& bundle = (*bundles_)[index];
  const AffineBundle<Real>& constants = bundle.constants;
  const FingerMemory<Real> memory{sums_.data() + kTurnSums * bundle.first, open_share_.data() + bundle.first,
                                  q_.data() + bundle.first, at_limit_.data() + bundle.first};
  input_.vectors = action.vectors;
  unsigned faded = 0;  // lanes
  for (int l = 0; l < static_cast<int>(constants.fingers.size()); ++l) {
    if (!decode_finger(constants.fingers[l], action, l)) faded |= 1u << l;
  }
  if (faded == 0) {
    lanes_.walk_whole(constants, input_, memory);
  } else {
    const unsigned all = (1u << constants.fingers.size()) - 1;
    if (faded != all) lanes_.affine_sums(constants, input_, memory);
    for (int l = 0; l < static_cast<int>(constants.fingers.size()); ++l)
      if ((faded >> l & 1) != 0) visit_points(bundle, action, l);
    lanes_.walk_sums(constants, input_, memory);
  }
  faded_[index] = faded;

  // turns have the same unit everywhere; a joint that has lost points goes on to its closed end
  if (faded == 0)
    for (const auto& place : bundle.places) q[place.joint] = memory.q[place.number];
  else
    for (const auto& place : bundle.places)
      q[place.joint] = close_by_share(model_->joints[place.joint], memory.q[place.number], share_left_at(index, place));
  for (const AffineFinger<Real>& finger : constants.fingers)
    for (const auto& [joint, value] : finger.others) q[joint] = model_->joints[joint].in_profile_units(value);
}

/// what closing has left of the weight that the joint carries
template <class Real>
Real SingleHand<Real>::share_left_at(std::size_t index, const typename Bundle::Place& place) const noexcept {
  const Bundle& bundle = (*bundles_)[index];
  const bool is_fitted = place.step != bundle.constants.before;
  return is_fitted && (faded_[index] >> place.lane & 1) != 0 ? open_share_[bundle.first + place.number] : Real(1);
}

/// What the action says to the finger in a lane. Returns whether its sums are affine.
template <class Real>
bool SingleHand<Real>::decode_finger(const AffineFinger<Real>& finger, const ActionNumbers<Real>& action,
                                     int lane) noexcept {
  std::array<Real, kMaxDrivingVectors> delta_r;
  const Real delta_theta = model_->decoder.decode_numbers(action, finger.finger, delta_r.data());
  input_.azimuth[lane] = model_->azimuth_sign * delta_theta;
  input_.lateral[lane] = finger.lateral < 0 ? Real(0) : look_up_lateral(model_->laterals[finger.lateral], delta_theta);
  Real lowest = delta_r[0];
  for (int j = 0; j < action.vectors; ++j) {
    input_.delta_r[j][lane] = delta_r[j];
    lowest = min(lowest, delta_r[j]);
  }
  for (int u = 0; u < kLeadInputs; ++u)
    input_.leads[u][lane] = model_->decoder.default_lead(action.vectors, u, delta_r.data());
  return action.angles == 0 && lowest >= finger.lowest;
}

/// the sums of the finger in a lane, point by point, and its leads
template <class Real>
void SingleHand<Real>::visit_points(const Bundle& bundle, const ActionNumbers<Real>& action, int lane) noexcept {
  const AffineFinger<Real>& finger = bundle.constants.fingers[lane];
  PlaneDeformation<Real>& plane = cascade_.planes[finger.finger];
  plane.delta_theta = model_->azimuth_sign * input_.azimuth[lane];
  for (int j = 0; j < action.vectors; ++j) plane.delta_r[j] = input_.delta_r[j][lane];
  model_->decoder.complete(action, finger.finger, plane);
  for (int u = 0; u < kLeadInputs; ++u) input_.leads[u][lane] = plane.lead[u];
  cascade_.carry(*model_, model_->parts[finger.part]);
  const PointMoments<Real> nothing;
  for (int s = 0; s < bundle.constants.steps(); ++s) {
    const PointMoments<Real>& m = finger.joints[s] < 0 ? nothing : cascade_.carried(finger.joints[s]);
    const TurnSums<Real> sums = turn_sums(m);
    each_number(sums, [&, next = &sums_[kTurnSums * (bundle.first + s * lanes_.width) + lane]](Real number) mutable {
      *next = number;
      next += lanes_.width;
    });
    open_share_[bundle.first + s * lanes_.width + lane] = share_left(m.weight, m.full_weight, model_->options.closing);
  }
}

template <class Real>
void SingleHand<Real>::report(const ActionNumbers<Real>& action, std::span<const Real> q,
                              SolveReport& report) noexcept {
  model_->decoder.decode(action, cascade_.planes.data());
  cascade_.place_joints(*model_, q);
  report.residual_rms = squared_errors().rms();
  report.clamped = model_->decoder.clamps(action);

  std::fill(report.at_limit.begin(), report.at_limit.end(), 0);
  std::fill(report.closed.begin(), report.closed.end(), 0);
  const auto set = [&](int joint, bool at_limit, bool closed) {
    if (!report.at_limit.empty()) report.at_limit[joint] = at_limit;
    if (!report.closed.empty()) report.closed[joint] = closed;
  };
  for (std::size_t n = 0; n < bundles_->size(); ++n)
    for (const auto& place : (*bundles_)[n].places)
      set(place.joint, at_limit_[(*bundles_)[n].first + place.number] != 0, share_left_at(n, place) <= Real(0));
  for (int n : model_->other_parts)
    for (const ScopedJoint& s : model_->parts[n].tree)
      set(s.joint, cascade_.at_limit(s.joint), cascade_.closed(s.joint));
}

template <class Real>
SquaredErrors SingleHand<Real>::squared_errors() const noexcept {
  if (model_->options.field == FieldReading::field) return cascade_.squared_errors(*model_);
  std::array<SinCos<Real>, kSlotCount> azimuths;  // [finger]
  for (std::size_t f = 0; f < cascade_.planes.size(); ++f)
    azimuths[f] = sincos(model_->azimuth_sign * cascade_.planes[f].delta_theta);
  SquaredErrors errors;
  for (const SolverPatch<Real>& patch : model_->patches)
    errors.add(lanes_.squared_errors(patch.columns, cascade_.planes[patch.finger], model_->options.closing,
                                     from_turned_axes(cascade_.frame(patch.joint), azimuths[patch.finger])));
  return errors;
}

template class SingleHand<float>;
template class SingleHand<double>;

namespace {

/// One hand after the other, by the code of a single solve.
template <class Real>
struct ScalarLanes {
  static void* make(const SolverModel<Real>& model) { return new SingleHand<Real>(model); }
  static void destroy(void* scratch) { delete static_cast<SingleHand<Real>*>(scratch); }
  static void take(void* scratch, const ActionRows<Real>& rows) {
    SingleHand<Real>& hand = *static_cast<SingleHand<Real>*>(scratch);
    hand.solve({.values = rows.values[0],
                .phi = rows.phi[0],
                .vectors = rows.vectors,
                .angles = rows.angles,
                .normalized = rows.normalized,
                .azimuth_offsets = rows.azimuth_offsets[0],
                .radial_bounds = rows.radial_bounds[0]},
               {rows.q[0], hand.joint_count()});
  }
  static void finish(void*) {}
};

}  // namespace

template <>
CascadeLanes<float> cascade_lanes_scalar() {
  return {1, &ScalarLanes<float>::make, &ScalarLanes<float>::destroy, &ScalarLanes<float>::take,
          &ScalarLanes<float>::finish};
}
template <>
CascadeLanes<double> cascade_lanes_scalar() {
  return {1, &ScalarLanes<double>::make, &ScalarLanes<double>::destroy, &ScalarLanes<double>::take,
          &ScalarLanes<double>::finish};
}

}  // namespace uhas
