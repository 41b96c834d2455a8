#include "uhas/runtime/cascade/lead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "uhas/runtime/encoding/damped_least_squares.hpp"

namespace uhas {
namespace {

constexpr int kMostUnknowns = 16;  // of a finger; one with more has no leads

/// A finger at the start of the cascade, in S.
template <class Real>
class FingerAtRest {
 public:
  FingerAtRest(const SolverModel<Real>& model, int finger) : model_(model), T_S_joint_(model.joints.size()) {
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      const SolverJoint<Real>& joint = model.joints[i];
      const RigidTransformd T =
          joint.moved(joint.T_parent_joint.template cast<double>(), joint.start.template cast<double>());
      T_S_joint_[i] = joint.parent < 0 ? T : T_S_joint_[joint.parent] * T;
    }
    for (const SolverStep& step : model.steps)
      if (step.fingers.size() == 1 && step.fingers[0] == finger) steps_.push_back(&step);
    for (const SolverPoint<Real>& point : model.points) {
      if (point.finger != finger) continue;
      points_.push_back({point.joint, T_S_joint_[point.joint] * point.p.template cast<double>(),
                         point.direction.template cast<double>(), lead_shares(double(point.phi)),
                         double(point.weight)});
    }
  }

  const std::vector<const SolverStep*>& steps() const { return steps_; }

  /// What the steps do in the best fit, rad or radii a radius of each displacement.
  std::vector<std::array<double, kLeadInputs>> best_moves() const {
    const int n = static_cast<int>(steps_.size());
    std::array<DampedLeastSquares<kMostUnknowns>, kLeadInputs> fits{DampedLeastSquares<kMostUnknowns>(n),
                                                                    DampedLeastSquares<kMostUnknowns>(n)};
    double stiffest = 0;
    for (const Point& point : points_) {
      std::array<Vector3d, kMostUnknowns> motion;
      for (int s = 0; s < n; ++s) {
        motion[s] = motion_of(*steps_[s], point);
        stiffest += point.weight * dot(motion[s], motion[s]);
      }
      for (double Vector3d::*axis : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
        std::array<double, kMostUnknowns> row{};
        for (int s = 0; s < n; ++s) row[s] = motion[s].*axis;
        for (int u = 0; u < kLeadInputs; ++u)
          fits[u].add({row.data(), std::size_t(n)}, point.shares[u] * point.direction.*axis, point.weight);
      }
    }
    std::vector<std::array<double, kLeadInputs>> moves(n);
    constexpr double damping = 1e-9;  // for a step that moves no point
    for (int u = 0; u < kLeadInputs; ++u) {
      const auto x = fits[u].solve(damping * stiffest + std::numeric_limits<double>::min());
      for (int s = 0; s < n; ++s) moves[s][u] = x[s];
    }
    return moves;
  }

  /// What step `s` does in the cascade's own fit of a single turning joint, when the steps before it have
  /// made their `moves`.
  std::array<double, kLeadInputs> own_move(int s, std::span<const std::array<double, kLeadInputs>> moves,
                                           double decay) const {
    const int joint = steps_[s]->joint;
    const Vector3d z = T_S_joint_[joint].rotation.column(2);
    double weight = 0, stiffness = 0;
    Vector3d arms;
    std::array<double, kLeadInputs> pull{};
    for (const Point& point : points_) {
      const int between = joints_between(joint, point.joint);
      if (between < 0) continue;
      const double w = point.weight * std::pow(decay, between);
      const Vector3d motion = motion_of(*steps_[s], point);
      weight += w;
      arms += w * cross(motion, z);  // the arm, across the axis
      stiffness += w * dot(motion, motion);
      for (int u = 0; u < kLeadInputs; ++u) {
        Vector3d error = point.shares[u] * point.direction;
        for (int p = 0; p < s; ++p) error += -moves[p][u] * motion_of(*steps_[p], point);
        pull[u] += w * dot(motion, error);
      }
    }
    if (!(stiffness > 0)) return moves[s];
    const double hold = kHold * dot(arms, arms) / weight;
    for (double& move : pull) move /= stiffness + hold;
    return pull;
  }

 private:
  struct Point {
    int joint;
    Vector3d p, direction;
    std::array<double, kLeadInputs> shares;  // of each displacement in that at the point
    double weight;
  };

  std::array<double, kLeadInputs> lead_shares(double phi) const {
    std::array<double, kLeadInputs> shares{};
    for (int u = 0; u < kLeadInputs; ++u) {
      PlaneDeformation<double> unit{};
      unit.vectors = kLeadInputs;
      std::copy_n(kLeadAngles.begin(), kLeadInputs, unit.phi.begin());
      unit.delta_r[u] = 1;
      unit.complete(model_.options.convention.held_toward_pole, true);
      shares[u] = unit.at(phi).delta_r;
    }
    return shares;
  }

  /// Independent joints from `outer` inward to `inner`, which is not counted; -1 when that does not carry it.
  int joints_between(int inner, int outer) const {
    int count = 0;
    for (; outer > inner; outer = model_.joints[outer].parent) count += !model_.joints[outer].follows;
    return outer == inner ? count : -1;
  }

  /// Of a point, a unit of the step's unknown.
  Vector3d motion_of(const SolverStep& step, const Point& point) const {
    Vector3d motion;
    for (int i : step.driven) {
      if (joints_between(i, point.joint) < 0) continue;
      const Vector3d z = T_S_joint_[i].rotation.column(2);
      const double rate = i == step.joint ? 1.0 : double(model_.joints[i].ratio);
      motion += rate * (model_.joints[i].prismatic ? z : cross(z, point.p - T_S_joint_[i].translation));
    }
    return motion;
  }

  const SolverModel<Real>& model_;
  std::vector<RigidTransformd> T_S_joint_;  // moved frames
  std::vector<const SolverStep*> steps_;    // root to tip
  std::vector<Point> points_;
};

}  // namespace

template <class Real>
void set_leads(SolverModel<Real>& model) {
  for (int f = 0; f < static_cast<int>(model.tip_joint.size()); ++f) {
    const FingerAtRest<Real> finger(model, f);
    const int n = static_cast<int>(finger.steps().size());
    if (n > kMostUnknowns) continue;
    const auto moves = finger.best_moves();
    for (int s = 0; s < n; ++s) {
      SolverJoint<Real>& joint = model.joints[finger.steps()[s]->joint];
      if (!finger.steps()[s]->single || joint.prismatic) continue;
      const auto own = finger.own_move(s, moves, double(model.passes.front().decay));
      for (int u = 0; u < kLeadInputs; ++u) joint.lead[u] = static_cast<Real>(moves[s][u] - own[u]);
    }
  }
}

template void set_leads<float>(SolverModel<float>& model);
template void set_leads<double>(SolverModel<double>& model);

}  // namespace uhas
