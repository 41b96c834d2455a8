#include "uhas/runtime/cascade/lead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "uhas/runtime/encoding/damped_least_squares.hpp"

namespace uhas {
namespace {

constexpr int kMostUnknowns = 16;  // of a finger; one with more has no leads

/// How far a step moves its unknown, rad or radii a radius of each input.
using Move = std::array<double, kLeadInputs>;

/// The share of each input in the displacement at polar angle `phi`.
Move input_shares(double phi, bool held_toward_pole) {
  Move shares{};
  for (int u = 0; u < kLeadInputs; ++u) {
    PlaneDeformation<double> unit{};
    unit.vectors = kLeadInputs;
    std::copy_n(kLeadAngles.begin(), kLeadInputs, unit.phi.begin());
    unit.delta_r[u] = 1;
    unit.complete(held_toward_pole, true);
    shares[u] = unit.at(phi).delta_r;
  }
  return shares;
}

/// A finger at the start of the cascade, in S.
template <class Real>
class FingerAtRest {
 public:
  FingerAtRest(const FirstPass<Real>& pass, int finger) : joints_(pass.joints), T_S_joint_(pass.joints.size()) {
    // the frames of all joints, as the start moves them
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const SolverJoint<Real>& joint = joints_[i];
      const RigidTransformd T =
          joint.moved(joint.T_parent_joint.template cast<double>(), pass.starts[i].value.template cast<double>());
      T_S_joint_[i] = joint.parent < 0 ? T : T_S_joint_[joint.parent] * T;
    }
    // what moves this finger alone, and the points that it moves
    for (const SolverStep& step : pass.steps)
      if (step.fingers.size() == 1 && step.fingers[0] == finger) steps_.push_back(&step);
    for (const SolverPoint<Real>& point : pass.points) {
      if (point.finger != finger) continue;
      points_.push_back({point.joint, T_S_joint_[point.joint] * point.p.template cast<double>(),
                         point.direction.template cast<double>(),
                         input_shares(double(point.phi), pass.held_toward_pole), double(point.weight)});
    }
  }

  const std::vector<const SolverStep*>& steps() const { return steps_; }

  /// What the steps do in the best fit: K of the normal equations H K = G.
  std::vector<Move> best_moves() const {
    const int n = static_cast<int>(steps_.size());
    std::array<DampedLeastSquares<kMostUnknowns>, kLeadInputs> fits{DampedLeastSquares<kMostUnknowns>(n),
                                                                    DampedLeastSquares<kMostUnknowns>(n)};
    double stiffest = 0;
    for (const Point& point : points_) {
      // J of the point: how each step moves it
      std::array<Vector3d, kMostUnknowns> motion;
      for (int s = 0; s < n; ++s) {
        motion[s] = motion_of(*steps_[s], point);
        stiffest += point.weight * dot(motion[s], motion[s]);
      }
      // three rows of J K = dt/du, one a coordinate
      for (double Vector3d::*axis : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
        std::array<double, kMostUnknowns> row{};
        for (int s = 0; s < n; ++s) row[s] = motion[s].*axis;
        for (int u = 0; u < kLeadInputs; ++u)
          fits[u].add({row.data(), std::size_t(n)}, point.shares[u] * point.direction.*axis, point.weight);
      }
    }
    std::vector<Move> moves(n);
    constexpr double damping = 1e-9;  // for a step that moves no point
    for (int u = 0; u < kLeadInputs; ++u) {
      const auto x = fits[u].solve(damping * stiffest + std::numeric_limits<double>::min());
      for (int s = 0; s < n; ++s) moves[s][u] = x[s];
    }
    return moves;
  }

  /// What step `s` does in the cascade's own fit of a single turning joint, when the steps before it have
  /// made their `moves`.
  Move own_move(int s, std::span<const Move> moves, double decay) const {
    const int joint = steps_[s]->joint;
    const Vector3d z = T_S_joint_[joint].rotation.column(2);
    double weight = 0, stiffness = 0;
    Vector3d arms;
    Move pull{};
    for (const Point& point : points_) {
      const int between = joints_between(joint, point.joint);
      if (between < 0) continue;
      const double w = point.weight * std::pow(decay, between);
      const Vector3d motion = motion_of(*steps_[s], point);
      weight += w;
      arms += w * cross(motion, z);  // the arm, across the axis
      stiffness += w * dot(motion, motion);
      // what the parents' moves have left of the way to the target
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
    Move shares;  // of each input in the displacement at the point
    double weight;
  };

  /// Independent joints from `outer` inward to `inner`, which is not counted; -1 when that does not carry it.
  int joints_between(int inner, int outer) const {
    int count = 0;
    for (; outer > inner; outer = joints_[outer].parent) count += !joints_[outer].follows;
    return outer == inner ? count : -1;
  }

  /// Of a point, a unit of the step's unknown.
  Vector3d motion_of(const SolverStep& step, const Point& point) const {
    Vector3d motion;
    for (int i : step.driven) {
      if (joints_between(i, point.joint) < 0) continue;
      const Vector3d z = T_S_joint_[i].rotation.column(2);
      const double rate = i == step.joint ? 1.0 : double(joints_[i].ratio);
      motion += rate * (joints_[i].prismatic ? z : cross(z, point.p - T_S_joint_[i].translation));
    }
    return motion;
  }

  const std::vector<SolverJoint<Real>>& joints_;
  std::vector<RigidTransformd> T_S_joint_;  // moved frames
  std::vector<const SolverStep*> steps_;    // root to tip
  std::vector<Point> points_;
};

}  // namespace

template <class Real>
std::vector<SolverLead<Real>> compile_leads(const FirstPass<Real>& pass, std::size_t finger_count) {
  std::vector<SolverLead<Real>> leads(pass.joints.size(), SolverLead<Real>{});
  for (int f = 0; f < static_cast<int>(finger_count); ++f) {
    const FingerAtRest<Real> finger(pass, f);
    const int n = static_cast<int>(finger.steps().size());
    if (n > kMostUnknowns) continue;
    const std::vector<Move> moves = finger.best_moves();
    for (int s = 0; s < n; ++s) {
      const SolverStep& step = *finger.steps()[s];
      if (!step.single || pass.joints[step.joint].prismatic) continue;
      const Move own = finger.own_move(s, moves, double(pass.decay));
      for (int u = 0; u < kLeadInputs; ++u) leads[step.joint][u] = static_cast<Real>(moves[s][u] - own[u]);
    }
  }
  return leads;
}

template std::vector<SolverLead<float>> compile_leads<float>(const FirstPass<float>&, std::size_t);
template std::vector<SolverLead<double>> compile_leads<double>(const FirstPass<double>&, std::size_t);

}  // namespace uhas
