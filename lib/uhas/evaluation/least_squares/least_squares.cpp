#include "uhas/evaluation/least_squares/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "uhas/base/spherical.hpp"
#include "uhas/evaluation/least_squares/driving_plane.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

std::vector<LeastSquares> LeastSquares::of_hand(const HandProfile& profile) {
  std::vector<LeastSquares> problems;
  for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f) {
    LeastSquares problem(profile);
    problem.fingers_ = {f};
    for (int joint : profile.fingers[f].joints) {
      const int master = profile.tree.joints[joint].mimic_master, unknown = master < 0 ? joint : master;
      if (profile.joint_traits[unknown].joint_class == JointClass::encompassing &&
          !contains(problem.unknowns_, unknown))
        problem.unknowns_.push_back(unknown);
    }
    // fingers that share an unknown are one problem
    for (std::size_t k = 0; k < problems.size();) {
      const std::vector<int>& others = problems[k].unknowns_;
      if (std::none_of(others.begin(), others.end(), [&](int u) { return contains(problem.unknowns_, u); })) {
        ++k;
        continue;
      }
      problem.fingers_.insert(problem.fingers_.begin(), problems[k].fingers_.begin(), problems[k].fingers_.end());
      for (int u : others)
        if (!contains(problem.unknowns_, u)) problem.unknowns_.push_back(u);
      problems.erase(problems.begin() + static_cast<std::ptrdiff_t>(k));
    }
    problems.push_back(std::move(problem));
  }
  for (LeastSquares& problem : problems) {
    std::sort(problem.unknowns_.begin(), problem.unknowns_.end());
    problem.add_points();
  }
  std::erase_if(problems, [](const LeastSquares& p) { return p.unknowns_.empty() || p.points_.empty(); });
  return problems;
}

void LeastSquares::add_points() {
  for (int f : fingers_)
    for (int joint : profile_->fingers[f].joints)
      for (int j = joint; j >= 0 && !contains(joints_, j); j = profile_->tree.joints[j].parent) joints_.push_back(j);
  std::sort(joints_.begin(), joints_.end());
  T_palm_joint_.resize(profile_->tree.joints.size());

  for (const Correspondence& c : profile_->correspondences) {
    const ProfileLink& link = profile_->links[c.link];
    if (c.weight <= 0 || !contains(joints_, link.joint)) continue;
    // of the fingers that share the joint, the one nearest in azimuth
    const auto distance = [&](int f) { return std::abs(wrap_angle(c.theta - profile_->fingers[f].theta_initial)); };
    int nearest = -1;
    for (int f : fingers_)
      if (contains(profile_->fingers[f].joints, link.joint) && (nearest < 0 || distance(f) < distance(nearest)))
        nearest = f;
    points_.push_back({.joint = link.joint,
                       .finger = nearest,
                       .p_joint = link.T_joint_link * c.p_link,
                       .theta = c.theta,
                       .phi = c.phi,
                       .rho = c.rho,
                       .weight = c.weight});
  }
}

void LeastSquares::set_action(std::span<const double> action) {
  const ActionSpace space(*profile_);
  std::vector<DrivingPlane> planes;
  for (const ProfileFinger& finger : profile_->fingers) planes.push_back(driving_plane(finger, space, action));
  weight_ = 0;
  for (Point& point : points_) {
    const DrivingPlane& plane = planes[point.finger];
    const double azimuth = (profile_->mirrored ? -1 : 1) * (point.theta + plane.delta_theta);
    const double radius = profile_->radius * std::max(point.rho + plane.at(point.phi), 0.0);
    point.t_palm = profile_->T_palm_sphere * from_spherical<double>({azimuth, point.phi, radius});
    point.share = plane.open_share(point.phi);
    weight_ += point.weight * point.share;
  }
}

void LeastSquares::place(std::span<const double> q) { forward_kinematics(profile_->tree, q, joints_, T_palm_joint_); }

double LeastSquares::rms(std::span<const double> q) {
  place(q);
  double sum = 0;
  for (const Point& point : points_) {
    const Vector3d e = (T_palm_joint_[point.joint] * point.p_joint - point.t_palm) / profile_->radius;
    sum += point.weight * point.share * dot(e, e);
  }
  return std::sqrt(sum / weight_);
}

double LeastSquares::mean_square(std::span<double> q, std::span<const double> x, std::span<double> gradient) {
  const std::vector<Joint>& joints = profile_->tree.joints;
  for (std::size_t i = 0; i < x.size(); ++i) q[unknowns_[i]] = x[i];
  for (int j : joints_)
    if (joints[j].mimic_master >= 0)
      q[j] = joints[j].mimic_multiplier * q[joints[j].mimic_master] + joints[j].mimic_offset;
  place(q);
  std::fill(gradient.begin(), gradient.end(), 0.0);

  // d|e|^2/dq_j = 2 e . (a x (p - o)) = 2 a . ((p - o) x e): moments of the errors, summed from the points inward
  struct Moments {
    Vector3d force, torque;
  };
  std::vector<Moments> moments(gradient.empty() ? 0 : joints.size());
  double sum = 0;
  for (const Point& point : points_) {
    const Vector3d p = T_palm_joint_[point.joint] * point.p_joint, e = (p - point.t_palm) / profile_->radius;
    const double w = point.weight * point.share / weight_;
    sum += w * dot(e, e);
    if (gradient.empty()) continue;
    moments[point.joint].force += w * e;
    moments[point.joint].torque += w * cross(p, e);
  }
  if (gradient.empty()) return sum;
  for (std::size_t n = joints_.size(); n-- > 0;) {
    const int j = joints_[n];
    const Joint& joint = joints[j];
    const Vector3d axis = T_palm_joint_[j].rotation * joint.axis, origin = T_palm_joint_[j].translation;
    const double rate = joint.kind == JointKind::prismatic
                            ? dot(axis, moments[j].force)
                            : dot(axis, moments[j].torque - cross(origin, moments[j].force));
    const int unknown = joint.mimic_master < 0 ? j : joint.mimic_master;
    const auto at = std::lower_bound(unknowns_.begin(), unknowns_.end(), unknown);
    if (at != unknowns_.end() && *at == unknown)
      gradient[at - unknowns_.begin()] +=
          2 * rate * (joint.mimic_master < 0 ? 1 : joint.mimic_multiplier) / profile_->radius;
    if (joint.parent < 0) continue;
    moments[joint.parent].force += moments[j].force;
    moments[joint.parent].torque += moments[j].torque;
  }
  return sum;
}

}  // namespace uhas
