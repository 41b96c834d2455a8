#include "uhas/evaluation/reach.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/base/spherical.hpp"
#include "uhas/evaluation/least_squares/driving_plane.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {
namespace {

constexpr int kSteps = 40;           // from zero to either bound
constexpr double kLeastGain = 0.25;  // achieved over commanded, of a step that counts as followed
constexpr double kDead = 0.05;       // achieved over commanded, of the whole range

/// A hand that is asked for one input of one finger.
class Probe {
 public:
  Probe(const HandProfile& profile, int finger)
      : profile_(profile),
        finger_(profile.fingers[finger]),
        solver_(profile),
        T_sphere_palm_(profile.T_palm_sphere.inverse()) {
    q_.resize(profile.tree.joints.size());
  }

  /// Azimuth of the fingertip, canonical, less that at rest.
  double azimuth(const std::vector<double>& action) {
    pose(action);
    const RigidTransformd& T_palm_tip = T_palm_link_[finger_.tip_link];
    const double theta = to_spherical(T_sphere_palm_ * (T_palm_tip * finger_.p_tip_link)).azimuth;
    return wrap_angle((profile_.mirrored ? -theta : theta) - finger_.theta_initial);
  }

  /// How far the finger's points moved outward, as a factor of the pattern of the driving vectors first .. last.
  double displacement(const std::vector<double>& action, int first, int last) {
    pose(action);
    DrivingPlane pattern;  // of a unit of the input
    for (int j = first; j <= last; ++j) pattern.delta_r[j] = 1;
    double moved = 0, asked = 0;
    for (const Correspondence& c : profile_.correspondences) {
      const ProfileLink& link = profile_.links[c.link];
      if (c.weight <= 0 || std::ranges::find(finger_.joints, link.joint) == finger_.joints.end()) continue;
      const double share = pattern.at(c.phi);
      const double rho = norm(T_sphere_palm_ * (T_palm_link_[c.link] * c.p_link)) / profile_.radius;
      moved += c.weight * share * (rho - c.rho);
      asked += c.weight * share * share;
    }
    return asked > 0 ? moved / asked : 0;
  }

  const ProfileFinger& finger() const { return finger_; }

 private:
  void pose(const std::vector<double>& action) {
    solver_.solve({.values = action}, q_);
    T_palm_link_ = link_poses(profile_.tree, profile_.links, q_);
  }

  const HandProfile& profile_;
  const ProfileFinger& finger_;
  CascadeSolver<double> solver_;
  RigidTransformd T_sphere_palm_;
  std::vector<double> q_;
  std::vector<RigidTransformd> T_palm_link_;
};

/// Moves an input from zero to either bound. `achieved(x)` is what the hand makes of the value x.
template <class Achieved>
InputReach sweep(double lower, double upper, const Achieved& achieved) {
  InputReach reach{.lower = lower, .upper = upper};
  double least = 0, greatest = 0;
  const double rest = achieved(0);
  const auto go = [&](double bound, double& useful, double& achieved_there) {
    double before = rest;
    bool followed = true;
    for (int k = 1; k <= kSteps && bound != 0; ++k) {
      const double now = achieved(bound * k / kSteps);
      least = std::min(least, now - rest), greatest = std::max(greatest, now - rest);
      followed = followed && (now - before) / (bound / kSteps) >= kLeastGain;
      if (followed) useful = bound * k / kSteps, achieved_there = now - rest;
      before = now;
    }
  };
  go(lower, reach.useful_lower, reach.achieved_lower);
  go(upper, reach.useful_upper, reach.achieved_upper);
  const double range = upper - lower;
  reach.followed = range > 0 ? (reach.useful_upper - reach.useful_lower) / range : 0;
  reach.dead = !(greatest - least >= kDead * range) || range == 0;
  return reach;
}

FingerReach measure_finger(const HandProfile& profile, const ActionSpace& space, int finger) {
  Probe probe(profile, finger);
  const auto with = [&](const auto& set) {
    std::vector<double> action = space.zero();
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (probe.finger().slots[slot]) set(action, slot);
    return action;
  };
  const auto radial = [&](int first, int last) {
    return sweep(-kRadialBound, kRadialBound, [&](double x) {
      return probe.displacement(with([&](std::vector<double>& action, int slot) {
                                  for (int j = first; j <= last; ++j) action[ActionSpace::radial(slot, j)] = x;
                                }),
                                first, last);
    });
  };
  const auto slot = std::ranges::find(probe.finger().slots, true) - probe.finger().slots.begin();
  FingerReach reach;
  reach.azimuth = sweep(space.lower[slot], space.upper[slot], [&](double x) {
    return probe.azimuth(with([&](std::vector<double>& action, int s) { action[s] = x; }));
  });
  for (int j = 0; j < ActionSpace::kVectors; ++j) reach.radial.push_back(radial(j, j));
  reach.together = radial(0, ActionSpace::kVectors - 1);
  return reach;
}

}  // namespace

ReachScore measure_reach(const HandProfile& profile, std::span<const std::vector<double>> battery) {
  const ActionSpace space(profile);
  ReachScore score;
  for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f)
    score.fingers.push_back(measure_finger(profile, space, f));

  CascadeSolver<double> solver(profile);
  std::vector<double> q(profile.tree.joints.size());
  std::vector<std::uint8_t> at_limit(q.size());
  std::vector<int> counts(q.size());
  for (const std::vector<double>& action : battery) {
    SolveReport report{.residual_rms = 0, .at_limit = at_limit, .closed = {}};
    solver.solve({.values = action}, q, report);
    for (std::size_t i = 0; i < q.size(); ++i) counts[i] += at_limit[i];
  }
  for (std::size_t i = 0; i < q.size(); ++i)
    if (counts[i] > 0) score.clamped.push_back({static_cast<int>(i), counts[i] / static_cast<double>(battery.size())});
  return score;
}

}  // namespace uhas
