#include "uhas/runtime/sphere_controller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

void require_option(bool holds, const char* option, double value, const char* remedy) {
  if (!holds) throw Error(ErrorCode::invalid_option, "", option + (" is " + std::to_string(value)), remedy);
}

/// The largest speed of each independent joint: its own, or less where a follower would exceed its own.
std::vector<double> group_velocities(const KinematicTree& tree, double scale) {
  std::vector<double> velocities(tree.joints.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    const Joint& joint = tree.joints[i];
    const double multiplier = joint.mimic_master < 0 ? 1 : std::abs(joint.mimic_multiplier);
    if (joint.velocity_limit <= 0 || multiplier <= 0) continue;
    double& velocity = velocities[independent_joint(tree, static_cast<int>(i))];
    velocity = std::min(velocity, scale * joint.velocity_limit / multiplier);
  }
  return velocities;
}

template <class Real>
bool is_period(Real dt) {
  return std::isfinite(dt) && dt > 0;
}

}  // namespace

template <class Real>
SphereController<Real>::SphereController(const HandProfile& profile, const SphereControllerOptions& options)
    : solver_(profile, options.solve), time_constant_(Real(options.time_constant)), goal_(solver_.joint_count()) {
  const auto finite = [](double value) { return std::isfinite(value); };
  require_option(finite(options.velocity_scale) && options.velocity_scale > 0, "velocity_scale", options.velocity_scale,
                 "choose a number above 0");
  require_option(options.range_scale > 0 && options.range_scale <= 1, "range_scale", options.range_scale,
                 "choose a number above 0, at most 1");
  require_option(finite(options.time_constant) && options.time_constant >= 0, "time_constant", options.time_constant,
                 "choose a number of seconds, 0 for no smoothing");

  const std::vector<double> velocities = group_velocities(profile.tree, options.velocity_scale);
  Motions motions;
  for (std::size_t i = 0; i < profile.tree.joints.size(); ++i) {
    const Joint& joint = profile.tree.joints[i];
    const double middle = (joint.lower + joint.upper) / 2,
                 reach = options.range_scale * (joint.upper - joint.lower) / 2;
    motions.push_back({.lower = Real(joint.lower),
                       .upper = Real(joint.upper),
                       .goal_lower = Real(middle - reach),
                       .goal_upper = Real(middle + reach),
                       .velocity = Real(velocities[i]),
                       .master = joint.mimic_master,
                       .multiplier = Real(joint.mimic_multiplier),
                       .offset = Real(joint.mimic_offset)});
  }
  motions_ = std::make_shared<const Motions>(std::move(motions));
}

template <class Real>
int SphereController<Real>::joint_count() const noexcept {
  return solver_.joint_count();
}

template <class Real>
Status SphereController<Real>::reset(std::span<const Real> q, std::span<Real> targets) const noexcept {
  const Motions& motions = *motions_;
  if (targets.size() != motions.size()) return Status::wrong_size;
  if (const Status status = check(q); status != Status::ok) return status;
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (motions[i].master < 0) targets[i] = std::clamp(q[i], motions[i].lower, motions[i].upper);
  follow(targets);
  return Status::ok;
}

template <class Real>
Status SphereController<Real>::update(const Action<Real>& action, Real dt, std::span<Real> targets) noexcept {
  if (!is_period(dt)) return Status::invalid_period;
  if (const Status status = check(targets); status != Status::ok) return status;
  if (const Status status = solver_.solve(action, goal_); status != Status::ok) return status;
  step(goal_, dt, targets);
  return Status::ok;
}

template <class Real>
Status SphereController<Real>::approach(std::span<const Real> solution, Real dt,
                                        std::span<Real> targets) const noexcept {
  if (!is_period(dt)) return Status::invalid_period;
  for (const std::span<const Real> posture : {solution, std::span<const Real>(targets)})
    if (const Status status = check(posture); status != Status::ok) return status;
  step(solution, dt, targets);
  return Status::ok;
}

/// every independent joint one period on toward its goal, its followers after it
template <class Real>
void SphereController<Real>::step(std::span<const Real> solution, Real dt, std::span<Real> targets) const noexcept {
  const Motions& motions = *motions_;
  // what first-order smoothing lets through in one period
  const Real share = time_constant_ > 0 ? -std::expm1(-dt / time_constant_) : Real(1);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& motion = motions[i];
    if (motion.master >= 0) continue;
    // toward the goal in its narrowed range, no faster than the joint may
    const Real from = std::clamp(targets[i], motion.lower, motion.upper);
    const Real way = share * (std::clamp(solution[i], motion.goal_lower, motion.goal_upper) - from);
    const Real longest = motion.velocity * dt;
    targets[i] = std::clamp(from + std::clamp(way, -longest, longest), motion.lower, motion.upper);
  }
  follow(targets);
}

template <class Real>
Status SphereController<Real>::check(std::span<const Real> q) const noexcept {
  if (q.size() != motions_->size()) return Status::wrong_size;
  for (std::size_t i = 0; i < q.size(); ++i)
    if ((*motions_)[i].master < 0 && !std::isfinite(q[i])) return Status::non_finite_input;
  return Status::ok;
}

/// followers stand where their masters put them
template <class Real>
void SphereController<Real>::follow(std::span<Real> targets) const noexcept {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Motion& motion = (*motions_)[i];
    if (motion.master >= 0) targets[i] = motion.multiplier * targets[motion.master] + motion.offset;
  }
}

template class SphereController<float>;
template class SphereController<double>;

}  // namespace uhas
