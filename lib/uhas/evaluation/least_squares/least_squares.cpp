#include "uhas/evaluation/least_squares/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "uhas/base/spherical.hpp"
#include "uhas/evaluation/least_squares/driving_plane.hpp"
#include "uhas/kinematics/finger_groups.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

std::vector<LeastSquares> LeastSquares::of_hand(const HandProfile& profile) {
  std::vector<std::vector<int>> unknowns;  // [finger]
  for (const ProfileFinger& finger : profile.fingers) {
    unknowns.push_back(independent_joints(profile.tree, finger.joints));
    std::erase_if(unknowns.back(),
                  [&](int joint) { return profile.joint_traits[joint].joint_class != JointClass::encompassing; });
  }

  std::vector<LeastSquares> problems;
  for (const std::vector<int>& group : group_fingers(unknowns)) {
    LeastSquares& problem = problems.emplace_back(LeastSquares(profile));
    problem.fingers_.assign(group.rbegin(), group.rend());
    std::set<int> of_group;
    for (int f : group) of_group.insert(unknowns[f].begin(), unknowns[f].end());
    problem.unknowns_.assign(of_group.begin(), of_group.end());
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
  apply_mimics(profile_->tree, q);
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
    const int unknown = independent_joint(profile_->tree, j);
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
