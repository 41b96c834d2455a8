#include "uhas/runtime/encoding/encoding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"
#include "uhas/runtime/encoding/damped_least_squares.hpp"

namespace uhas {
namespace {

constexpr int kMaxUnknowns = kSlotCount * (1 + kMaxDrivingVectors);  // five fingers in one group

/// Added to the displacements of the linear start, one start after the other: to those of the first and third
/// driving vector, and to those of the second and fourth. Closing begins to fade at delta r = -0.5, with zero slope,
/// so a descent that comes from above does not enter: the second start lies beyond. Neighbours may also fit the
/// wrong way round.
struct StartShift {
  double odd, even;
};
constexpr std::array<StartShift, 4> kStarts{{{0.0, 0.0}, {-0.4, -0.4}, {-0.5, 0.5}, {0.5, -0.5}}};

// steps of a descent from one start: with the wider limits, then with the hand's own
constexpr int kRelaxedSteps = 10, kSteps = 30;

constexpr double kFirstDamping = 1e-3, kLeastDamping = 1e-9, kMostDamping = 1e3, kDampingFactor = 10;
constexpr double kLongestStep = 0.4;  // of an unknown: a hand that has closed feels nothing and would not come back
constexpr double kSettled = 1e-5;     // error of a group at which its descent ends (rad)

}  // namespace

template <class Real>
Encoding<Real>::Encoding(const EncoderModel& model, const CascadeSolver<Real>& solver,
                         const CascadeSolver<Real>& relaxed_solver)
    : solver_(solver),
      relaxed_solver_(relaxed_solver),
      asked_(model.tree.joints.size()),
      target_(asked_.size()),
      start_(model.fingers.size()),
      T_palm_joint_(asked_.size()),
      values_(kSlotCount * (1 + model.driving_vectors)),
      best_{start_, std::vector<Real>(asked_.size()), std::vector<double>(model.groups.size())},
      now_(best_),
      trial_(best_),
      damping_(model.groups.size()) {
  std::size_t most = 0;
  for (const FingerGroup& group : model.groups) most = std::max(most, group.unknowns.size());
  derivatives_.assign(most, std::vector<double>(asked_.size()));
}

template <class Real>
void Encoding<Real>::run(const EncoderModel& model, std::span<const Real> q) noexcept {
  // the posture to reach, and the action read off it without solving
  set_target(model, q);
  model.start(target_, T_palm_joint_, start_);

  // from one start after the other until every group has settled; each group keeps the best that it has found
  std::fill(best_.cost.begin(), best_.cost.end(), std::numeric_limits<double>::infinity());
  for (const StartShift& shift : kStarts) {
    if (std::all_of(best_.cost.begin(), best_.cost.end(), is_settled)) break;
    begin(model, shift.odd, shift.even);
    // first with wide limits, at which no joint of a posture inside is held. Delta theta waits there: that of the table
    // is exact for every posture that a solve gives
    descend(model, relaxed_solver_, Freedom::displacements, kRelaxedSteps);
    descend(model, solver_, Freedom::all, kSteps);
    for (std::size_t g = 0; g < model.groups.size(); ++g)
      if (now_.cost[g] < best_.cost[g]) copy_group(model.groups[g], g, now_, best_);
  }
}

/// asked for: any posture, continuous joints within one turn of their middle; the target: what a solve can give of it
template <class Real>
void Encoding<Real>::set_target(const EncoderModel& model, std::span<const Real> q) noexcept {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = model.tree.joints[i];
    if (joint.mimic_master >= 0) continue;
    asked_[i] = double(q[i]);
    if (joint.kind == JointKind::continuous) {
      const double middle = (joint.lower + joint.upper) / 2;
      asked_[i] = middle + std::remainder(asked_[i] - middle, 2 * std::numbers::pi);
    }
    target_[i] = clamp_to_limits(joint, asked_[i]);
  }
  apply_mimics(model.tree, target_);
}

/// the linear start, displaced; a group that has settled stays
template <class Real>
void Encoding<Real>::begin(const EncoderModel& model, double odd_shift, double even_shift) noexcept {
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    for (int f : model.groups[g].fingers) now_.actions[f] = is_settled(best_.cost[g]) ? best_.actions[f] : start_[f];
    if (is_settled(best_.cost[g])) continue;
    for (int u = 0; u < model.groups[g].displacements; ++u) {
      const auto [f, number] = model.groups[g].unknowns[u];
      const EncoderFinger& finger = model.fingers[f];
      now_.actions[f][number] = std::clamp(start_[f][number] + (number % 2 == 1 ? odd_shift : even_shift),
                                           finger.lower[number], finger.upper[number]);
    }
  }
}

/// Levenberg's method: step by step downhill, each group with a damping of its own, all groups with the same solves
template <class Real>
void Encoding<Real>::descend(const EncoderModel& model, CascadeSolver<Real>& solver, Freedom freedom,
                             int steps) noexcept {
  solve(model, solver, now_);
  std::fill(damping_.begin(), damping_.end(), kFirstDamping);
  for (int n = 0; n < steps; ++n) {
    if (has_ended()) return;
    differentiate(model, solver, freedom);
    step(model, freedom);
    solve(model, solver, trial_);
    keep_better(model);
  }
}

/// the posture of an action, and how far each group is from the target: the sum of its squared errors
template <class Real>
void Encoding<Real>::solve(const EncoderModel& model, CascadeSolver<Real>& solver, Attempt& attempt) noexcept {
  model.write_action<Real>(attempt.actions, values_);
  solver.solve({.values = values_, .driving_vectors_phi = {}}, attempt.q);
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    attempt.cost[g] = 0;
    for (int joint : model.groups[g].joints)
      attempt.cost[g] += error(model, attempt, joint) * error(model, attempt, joint);
  }
}

/// derivatives of every group's joints with respect to its unknowns, as differences of solves: one solve serves the
/// u-th unknown of all groups
template <class Real>
void Encoding<Real>::differentiate(const EncoderModel& model, CascadeSolver<Real>& solver, Freedom freedom) noexcept {
  // long enough that rounding spoils no more than a third of a difference's digits
  const double nudge = std::cbrt(double(std::numeric_limits<Real>::epsilon()));
  for (int u = 0; u < static_cast<int>(derivatives_.size()); ++u) {
    // every group's u-th unknown a little on, or back where it would pass its bound
    std::copy(now_.actions.begin(), now_.actions.end(), trial_.actions.begin());
    bool any = false;
    for (const FingerGroup& group : model.groups) {
      if (u >= unknown_count(group, freedom)) continue;
      const auto [f, number] = group.unknowns[u];
      double& x = trial_.actions[f][number];
      x += x + nudge <= model.fingers[f].upper[number] ? nudge : -nudge;
      any = true;
    }
    if (!any) return;

    // what that moves
    solve(model, solver, trial_);
    for (const FingerGroup& group : model.groups) {
      if (u >= unknown_count(group, freedom)) continue;
      const auto [f, number] = group.unknowns[u];
      const double moved = trial_.actions[f][number] - now_.actions[f][number];
      for (int joint : group.joints)
        derivatives_[u][joint] = (error(model, trial_, joint) - error(model, now_, joint)) / moved;
    }
  }
}

/// from `now_` to the action of `trial_`: one damped Gauss-Newton step of every group
///   min over change of  sum over joints (error + sum over u of derivative_u change_u)^2 + damping |change|^2
template <class Real>
void Encoding<Real>::step(const EncoderModel& model, Freedom freedom) noexcept {
  std::copy(now_.actions.begin(), now_.actions.end(), trial_.actions.begin());
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    const FingerGroup& group = model.groups[g];
    const int unknowns = unknown_count(group, freedom);

    // an equation a joint
    DampedLeastSquares<kMaxUnknowns> equations(unknowns);
    for (int joint : group.joints) {
      std::array<double, kMaxUnknowns> row{};
      for (int u = 0; u < unknowns; ++u) row[u] = derivatives_[u][joint];
      equations.add(row, -error(model, now_, joint), 1.0);
    }
    const auto change = equations.solve(damping_[g]);

    // shortened until no unknown goes too far, and held within bounds
    double longest = kLongestStep;
    for (double c : change) longest = std::max(longest, std::abs(c));
    for (int u = 0; u < unknowns; ++u) {
      const auto [f, number] = group.unknowns[u];
      const EncoderFinger& finger = model.fingers[f];
      double& x = trial_.actions[f][number];
      x = std::clamp(x + change[u] * (kLongestStep / longest), finger.lower[number], finger.upper[number]);
    }
  }
}

/// a step downhill is taken and the next one is bolder; a step uphill is forgotten and the next one shorter
template <class Real>
void Encoding<Real>::keep_better(const EncoderModel& model) noexcept {
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    if (trial_.cost[g] < now_.cost[g]) {
      copy_group(model.groups[g], g, trial_, now_);
      damping_[g] = std::max(damping_[g] / kDampingFactor, kLeastDamping);
    } else {
      damping_[g] = std::min(damping_[g] * kDampingFactor, kMostDamping);
    }
  }
}

/// every group has settled, or finds nothing better however short its step
template <class Real>
bool Encoding<Real>::has_ended() const noexcept {
  for (std::size_t g = 0; g < damping_.size(); ++g)
    if (!is_settled(now_.cost[g]) && damping_[g] < kMostDamping) return false;
  return true;
}

template <class Real>
void Encoding<Real>::copy_group(const FingerGroup& group, std::size_t index, const Attempt& from,
                                Attempt& to) const noexcept {
  for (int f : group.fingers) to.actions[f] = from.actions[f];
  for (int joint : group.joints) to.q[joint] = from.q[joint];
  to.cost[index] = from.cost[index];
}

template <class Real>
double Encoding<Real>::error(const EncoderModel& model, const Attempt& attempt, int joint) const noexcept {
  return (double(attempt.q[joint]) - target_[joint]) / model.unit[joint];
}

template <class Real>
int Encoding<Real>::unknown_count(const FingerGroup& group, Freedom freedom) noexcept {
  return freedom == Freedom::displacements ? group.displacements : static_cast<int>(group.unknowns.size());
}

template <class Real>
bool Encoding<Real>::is_settled(double cost) noexcept {
  return cost <= kSettled * kSettled;
}

/// against the posture asked for, not the target: what lies beyond a limit counts
template <class Real>
EncodeReport Encoding<Real>::report(const EncoderModel& model) const noexcept {
  EncodeReport report;
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    if (model.tree.joints[i].mimic_master >= 0) continue;
    const double e = std::abs(double(best_.q[i]) - asked_[i]) / model.unit[i];
    report.residual_max = std::max(report.residual_max, e);
    sum += e * e;
    ++count;
  }
  report.residual_rms = std::sqrt(sum / count);
  return report;
}

template class Encoding<float>;
template class Encoding<double>;

}  // namespace uhas
