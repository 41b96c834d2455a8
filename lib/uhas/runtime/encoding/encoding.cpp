#include "uhas/runtime/encoding/encoding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"
#include "uhas/runtime/encoding/damped_least_squares.hpp"

namespace uhas {
namespace {

constexpr int kMaxUnknowns = kSlotCount * (1 + kMaxDrivingVectors);  // five fingers in one group

// errors of a group (rad): at which nothing is left to do, and at which no other start is tried
constexpr double kSettled = 1e-5, kFound = 5e-4;

// steps of a descent, uphill ones counted: from a sample, which settles in three or four or else rarely, and at the end
constexpr int kSteps = 5, kLastSteps = 15;

// A posture that a solve gives stands nearer to a sample, in 999 of 1,000 fingers; of one that none gives all starts
// find the same rest.
constexpr double kFar = 0.35;

constexpr double kFirstDamping = 1e-4, kLeastDamping = 1e-9, kMostDamping = 1e3, kDampingFactor = 10;
constexpr double kTrusted = 0.1;      // of the cost, left by a step after which derivatives need no solves
constexpr double kLongestStep = 0.4;  // of an unknown: a hand that has closed feels nothing and would not come back
constexpr double kNudge = 1e-5;       // of an unknown, for its derivatives: half of a double's digits are theirs

}  // namespace

Encoding::Encoding(const EncoderModel& model, const CascadeSolver<double>& solver)
    : solver_(solver),
      asked_(model.tree.joints.size()),
      target_(asked_.size()),
      starts_(model.fingers.size()),
      distances_(model.samples.size()),
      values_(kSlotCount * (1 + model.driving_vectors)),
      best_{std::vector<FingerAction>(model.fingers.size()), std::vector<double>(asked_.size()),
            std::vector<double>(model.groups.size())},
      now_(best_),
      trial_(best_),
      descents_(model.groups.size()) {
  std::size_t most = 0;
  for (const FingerGroup& group : model.groups) most = std::max(most, group.unknowns.size());
  derivatives_.assign(most, std::vector<double>(asked_.size()));
  solve(model);
  best_.q = trial_.q;  // joints of no finger stay there
}

template <class Real>
void Encoding::run(const EncoderModel& model, std::span<const Real> q) noexcept {
  std::copy(q.begin(), q.end(), asked_.begin());
  set_target(model);
  std::fill(best_.cost.begin(), best_.cost.end(), std::numeric_limits<double>::infinity());
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    descents_[g] = {};
    begin_at_sample(model, g);
  }
  const auto has_ended = [](const Descent& descent) { return descent.next == Next::nothing; };
  while (!std::all_of(descents_.begin(), descents_.end(), has_ended)) {
    solve(model);
    for (std::size_t g = 0; g < model.groups.size(); ++g) proceed(model, g);
  }
}

/// continuous joints within one turn of their middle, all within limits, followers where their masters put them
void Encoding::set_target(const EncoderModel& model) noexcept {
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const Joint& joint = model.tree.joints[i];
    if (joint.mimic_master >= 0) continue;
    if (joint.kind == JointKind::continuous) {
      const double middle = (joint.lower + joint.upper) / 2;
      asked_[i] = middle + std::remainder(asked_[i] - middle, 2 * std::numbers::pi);
    }
    target_[i] = clamp_to_limits(joint, asked_[i]);
  }
  apply_mimics(model.tree, target_);
}

/// each finger at its next sample, by the displacements alone: delta theta is exact for what a solve gives
void Encoding::begin_at_sample(const EncoderModel& model, std::size_t g) noexcept {
  const FingerGroup& group = model.groups[g];
  Descent& descent = descents_[g];
  for (int f : group.fingers) {
    const SampledStart start =
        model.start(model.fingers[f], target_, std::span(starts_[f]).first(descent.start), distances_);
    trial_.actions[f] = starts_[f][descent.start] = start.action;
    descent.is_far = descent.is_far || start.distance > kFar;
  }
  begin(descent, kSteps, group.displacements);
}

/// at the best so far, by all numbers: what no solve gives may come nearer
void Encoding::begin_at_best(const EncoderModel& model, std::size_t g) noexcept {
  const FingerGroup& group = model.groups[g];
  for (int f : group.fingers) trial_.actions[f] = best_.actions[f];
  descents_[g].is_last = true;
  begin(descents_[g], kLastSteps, static_cast<int>(group.unknowns.size()));
}

void Encoding::begin(Descent& descent, int steps, int unknowns) noexcept {
  descent.next = Next::look;
  descent.steps_left = steps;
  descent.unknowns = unknowns;
  descent.unknown = 0;
  descent.damping = kFirstDamping;
}

/// what a solve has told, and what the next one is to tell
void Encoding::proceed(const EncoderModel& model, std::size_t g) noexcept {
  const FingerGroup& group = model.groups[g];
  Descent& descent = descents_[g];
  switch (descent.next) {
    case Next::nothing: return;
    case Next::difference: {
      const auto [f, number] = group.unknowns[descent.unknown];
      const double moved = trial_.actions[f][number] - now_.actions[f][number];
      for (int joint : group.joints)
        derivatives_[descent.unknown][joint] = (error(model, trial_, joint) - error(model, now_, joint)) / moved;
      ++descent.unknown;
      break;
    }
    case Next::look: copy_group(group, g, trial_, now_); break;
    case Next::step:
      // a step downhill is taken and the next one is bolder; a step uphill is forgotten and the next one shorter
      --descent.steps_left;
      if (trial_.cost[g] < now_.cost[g]) {
        if (trial_.cost[g] < kTrusted * now_.cost[g])
          update_derivatives(model, g);
        else
          descent.unknown = 0;
        copy_group(group, g, trial_, now_);
        descent.damping = std::max(descent.damping / kDampingFactor, kLeastDamping);
      } else {
        descent.damping *= kDampingFactor;
      }
      break;
  }
  if (now_.cost[g] <= kSettled * kSettled || descent.steps_left == 0 || descent.damping > kMostDamping)
    end(model, g);
  else if (descent.unknown < descent.unknowns)
    difference(model, g);
  else
    step(model, g);
}

void Encoding::end(const EncoderModel& model, std::size_t g) noexcept {
  Descent& descent = descents_[g];
  if (now_.cost[g] < best_.cost[g]) copy_group(model.groups[g], g, now_, best_);
  const double cost = best_.cost[g];
  if (cost > kSettled * kSettled && !descent.is_last) {
    const bool tries_on = cost > kFound * kFound && !descent.is_far && ++descent.start < kStarts;
    return tries_on ? begin_at_sample(model, g) : begin_at_best(model, g);
  }
  // at rest while other groups go on: nothing is solved faster
  descent.next = Next::nothing;
  for (int f : model.groups[g].fingers) trial_.actions[f] = {};
}

/// an unknown a little on, or back where it would pass its bound
void Encoding::difference(const EncoderModel& model, std::size_t g) noexcept {
  for (int f : model.groups[g].fingers) trial_.actions[f] = now_.actions[f];
  const auto [f, number] = model.groups[g].unknowns[descents_[g].unknown];
  double& x = trial_.actions[f][number];
  x += x + kNudge <= model.fingers[f].upper[number] ? kNudge : -kNudge;
  descents_[g].next = Next::difference;
}

/// Broyden's update: the least change of the derivatives that tells of the step what the solve has told
void Encoding::update_derivatives(const EncoderModel& model, std::size_t g) noexcept {
  const FingerGroup& group = model.groups[g];
  const int unknowns = descents_[g].unknowns;
  std::array<double, kMaxUnknowns> moved;
  double squared = 0;
  for (int u = 0; u < unknowns; ++u) {
    const auto [f, number] = group.unknowns[u];
    moved[u] = trial_.actions[f][number] - now_.actions[f][number];
    squared += moved[u] * moved[u];
  }
  for (int joint : group.joints) {
    double untold = error(model, trial_, joint) - error(model, now_, joint);
    for (int u = 0; u < unknowns; ++u) untold -= derivatives_[u][joint] * moved[u];
    for (int u = 0; u < unknowns; ++u) derivatives_[u][joint] += untold * moved[u] / squared;
  }
}

/// one damped Gauss-Newton step:
///   min over change of  sum over joints (error + sum over u of derivative_u change_u)^2 + damping |change|^2
void Encoding::step(const EncoderModel& model, std::size_t g) noexcept {
  const FingerGroup& group = model.groups[g];
  const int unknowns = descents_[g].unknowns;

  // an equation a joint
  DampedLeastSquares<kMaxUnknowns> equations(unknowns);
  for (int joint : group.joints) {
    std::array<double, kMaxUnknowns> row;
    for (int u = 0; u < unknowns; ++u) row[u] = derivatives_[u][joint];
    equations.add(row, -error(model, now_, joint), 1.0);
  }
  const auto change = equations.solve(descents_[g].damping);

  // shortened until no unknown goes too far, and held within bounds
  double longest = kLongestStep;
  for (int u = 0; u < unknowns; ++u) longest = std::max(longest, std::abs(change[u]));
  for (int f : group.fingers) trial_.actions[f] = now_.actions[f];
  for (int u = 0; u < unknowns; ++u) {
    const auto [f, number] = group.unknowns[u];
    const EncoderFinger& finger = model.fingers[f];
    double& x = trial_.actions[f][number];
    x = std::clamp(x + change[u] * (kLongestStep / longest), finger.lower[number], finger.upper[number]);
  }
  descents_[g].next = Next::step;
}

/// the posture of the trial, and how far each group is from the target
void Encoding::solve(const EncoderModel& model) noexcept {
  model.write_action<double>(trial_.actions, values_);
  solver_.solve({.values = values_, .driving_vectors_phi = {}}, trial_.q);
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    trial_.cost[g] = 0;
    for (int joint : model.groups[g].joints)
      trial_.cost[g] += error(model, trial_, joint) * error(model, trial_, joint);
  }
}

void Encoding::copy_group(const FingerGroup& group, std::size_t index, const Attempt& from, Attempt& to) noexcept {
  for (int f : group.fingers) to.actions[f] = from.actions[f];
  for (int joint : group.joints) to.q[joint] = from.q[joint];
  to.cost[index] = from.cost[index];
}

double Encoding::error(const EncoderModel& model, const Attempt& attempt, int joint) const noexcept {
  return (attempt.q[joint] - target_[joint]) / model.unit[joint];
}

/// against the posture asked for, not the target: what lies beyond a limit counts
EncodeReport Encoding::report(const EncoderModel& model) const noexcept {
  const auto residual = [&](int joint) { return std::abs(best_.q[joint] - asked_[joint]) / model.unit[joint]; };
  EncodeReport report;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < static_cast<int>(asked_.size()); ++i) {
    if (model.tree.joints[i].mimic_master >= 0) continue;
    report.residual_max = std::max(report.residual_max, residual(i));
    sum += residual(i) * residual(i);
    ++count;
  }
  report.residual_rms = std::sqrt(sum / count);
  for (std::size_t f = 0; f < model.fingers.size(); ++f)
    for (int joint : model.fingers[f].joints)
      if (report.fingers[f].joint < 0 || residual(joint) > report.fingers[f].residual)
        report.fingers[f] = {joint, residual(joint)};
  return report;
}

template void Encoding::run<float>(const EncoderModel&, std::span<const float>) noexcept;
template void Encoding::run<double>(const EncoderModel&, std::span<const double>) noexcept;

}  // namespace uhas
