#include "support/stated_residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// The way from one azimuth to another, counterclockwise, in [0, 2 pi).
double way(double from, double to) {
  const double angle = std::fmod(to - from, 2 * kPi);
  return angle < 0 ? angle + 2 * kPi : angle;
}

double between(double a, double b, double blend) { return a + blend * (b - a); }

}  // namespace

ResidualCheck::ResidualCheck(const HandProfile& profile, const SolveOptions& options)
    : profile_(profile), options_(options), T_palm_joint_(profile.tree.joints.size()) {
  std::vector<int> order(profile.fingers.size());
  std::iota(order.begin(), order.end(), 0);
  const auto theta = [&](int f) { return profile.fingers[f].theta_initial; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return theta(a) < theta(b); });
  constexpr double one_plane = 5 * kPi / 180;
  // begin behind the widest gap, so that no group is cut in two by where azimuths wrap
  std::size_t first = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto gap_before = [&](std::size_t n) {
      return way(theta(order[(n + order.size() - 1) % order.size()]), theta(order[n]));
    };
    if (gap_before(k) > gap_before(first)) first = k;
  }
  std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
  for (int f : order) {
    if (groups_.empty() || way(theta(groups_.back().back()), theta(f)) >= one_plane) groups_.emplace_back();
    groups_.back().push_back(f);
  }
  for (const std::vector<int>& group : groups_) {
    double sum = 0;  // of the way from the first: a group is narrow
    for (int f : group) sum += way(theta(group.front()), theta(f));
    azimuths_.push_back(theta(group.front()) + sum / double(group.size()));
  }
  add_points();
}

void ResidualCheck::add_points() {
  for (const Correspondence& c : profile_.correspondences) {
    const ProfileLink& link = profile_.links[c.link];
    Point point{.joint = link.joint,
                .finger = -1,
                .p_joint = link.T_joint_link * c.p_link,
                .direction = {},
                .phi = c.phi,
                .rho = c.rho,
                .weight = c.weight,
                .before = 0,
                .after = 0,
                .blend = 0};
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(profile_.fingers.size()); ++f) {
      const std::vector<int>& joints = profile_.fingers[f].joints;
      const double distance = std::abs(wrap_angle(c.theta - profile_.fingers[f].theta_initial));
      if (std::find(joints.begin(), joints.end(), link.joint) != joints.end() && distance < least)
        point.finger = f, least = distance;
    }
    if (c.weight <= 0 || point.finger < 0) continue;
    point.direction = from_spherical<double>({profile_.mirrored ? -c.theta : c.theta, c.phi, 1.0});
    place_between_planes(point, c.theta);
    points_.push_back(point);
  }
}

void ResidualCheck::place_between_planes(Point& point, double theta) const {
  for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
    if (way(azimuths_[g], theta) < way(azimuths_[point.before], theta)) point.before = g;
    if (way(theta, azimuths_[g]) < way(theta, azimuths_[point.after])) point.after = g;
  }
  const double behind = way(azimuths_[point.before], theta), ahead = way(theta, azimuths_[point.after]);
  point.blend = behind + ahead > 0 ? behind / (behind + ahead) : 0;
}

double ResidualCheck::Plane::at(double angle, bool held_toward_pole) const {
  if (angle >= phi.back()) return delta_r.back();
  std::size_t j = 0;
  while (angle > phi[j]) ++j;
  if (j == 0) return held_toward_pole ? delta_r[0] : delta_r[0] * (angle / phi[0]);
  return between(delta_r[j - 1], delta_r[j], (angle - phi[j - 1]) / (phi[j] - phi[j - 1]));
}

ResidualCheck::Plane ResidualCheck::plane_of(const ProfileFinger& finger, const Action<double>& action) const {
  const ActionConvention& convention = options_.convention;
  const int vectors = static_cast<int>(action.values.size()) / kSlotCount - 1;
  const auto bounded = [&](double value, double lower, double upper) {
    if (action.normalized) value *= value < 0 ? -lower : upper;
    return std::clamp(value, lower, upper);
  };
  double lower = 0, upper = 0;
  if (finger.lateral_table >= 0) {
    lower = profile_.lateral_tables[finger.lateral_table].delta_theta_lower;
    upper = profile_.lateral_tables[finger.lateral_table].delta_theta_upper;
  }
  const double lowest = action.radial_bounds.empty() ? convention.radial_lower : action.radial_bounds[0];
  const double highest = action.radial_bounds.empty() ? convention.radial_upper : action.radial_bounds[1];

  std::vector<Plane> slots;
  for (int slot = 0; slot < kSlotCount; ++slot) {
    if (!finger.slots[slot]) continue;
    Plane plane;
    plane.delta_theta = bounded(convention.azimuth_sign * action.values[slot], lower, upper);
    if (!action.azimuth_offsets.empty())
      plane.delta_theta = std::clamp(plane.delta_theta + action.azimuth_offsets[slot], lower, upper);
    for (int j = 0; j < vectors; ++j) {
      const double input = bounded(action.values[kSlotCount + vectors * slot + j], lowest, highest);
      plane.delta_r.push_back(convention.absolute_radii ? input - 1 : input);
      const std::span<const double> phi = action.driving_vectors_phi;
      if (phi.empty())
        plane.phi.push_back(kPi * (j + 1) / (vectors + 1));
      else
        plane.phi.push_back(phi.size() == static_cast<std::size_t>(vectors) ? phi[j] : phi[vectors * slot + j]);
    }
    slots.push_back(plane);
  }
  std::vector<int> all(slots.size());
  std::iota(all.begin(), all.end(), 0);
  return mean(slots, all);
}

ResidualCheck::Plane ResidualCheck::mean(const std::vector<Plane>& planes, const std::vector<int>& which) {
  Plane mean{.delta_theta = 0, .phi = std::vector<double>(planes.front().phi.size()), .delta_r = {}};
  mean.delta_r = mean.phi;
  for (int k : which) {
    mean.delta_theta += planes[k].delta_theta / double(which.size());
    for (std::size_t j = 0; j < mean.phi.size(); ++j) {
      mean.phi[j] += planes[k].phi[j] / double(which.size());
      mean.delta_r[j] += planes[k].delta_r[j] / double(which.size());
    }
  }
  return mean;
}

StatedResidual ResidualCheck::of(const Action<double>& action, std::span<const double> q, double epsilon) {
  const bool held = options_.convention.held_toward_pole, hard = options_.closing == CascadeClosing::hard;
  const bool own = options_.field == FieldReading::finger;
  const double sign = profile_.mirrored ? -1 : 1;

  std::vector<Plane> planes, field;
  double reach = 1;
  for (const ProfileFinger& finger : profile_.fingers) {
    planes.push_back(plane_of(finger, action));
    planes.back().cosine = std::cos(sign * planes.back().delta_theta);
    planes.back().sine = std::sin(sign * planes.back().delta_theta);
    for (double d : planes.back().delta_r) reach = std::max(reach, 1 + std::abs(d));
  }
  for (const std::vector<int>& group : groups_) field.push_back(mean(planes, group));
  const double rounding = epsilon * reach;

  forward_kinematics(profile_.tree, q, T_palm_joint_);
  const RigidTransformd T_sphere_palm = profile_.T_palm_sphere.inverse();
  for (RigidTransformd& T : T_palm_joint_) T = T_sphere_palm * T;

  double weight = 0, sum = 0, steepness = 0, pull = 0;
  doubtful_.clear();
  for (const Point& point : points_) {
    const Plane& a = own ? planes[point.finger] : field[point.before];
    const Plane& b = own ? a : field[point.after];
    const auto delta_r = [&](double phi) { return between(a.at(phi, held), b.at(phi, held), point.blend); };
    const double d = delta_r(point.phi), first = between(a.phi[0], b.phi[0], point.blend);
    const double radius_left = 1 + (hard ? d : delta_r(std::max(point.phi, first)));
    const double u = std::clamp(radius_left / 0.5, 0.0, 1.0);
    const double share = hard ? (radius_left < 0 ? 0 : 1) : u * u * (3 - 2 * u);

    const double turn = sign * between(a.delta_theta, b.delta_theta, point.blend);
    const double c = own ? a.cosine : std::cos(turn), s = own ? a.sine : std::sin(turn);
    const Vector3d& n = point.direction;
    const Vector3d t = std::max(point.rho + d, 0.0) * Vector3d{c * n.x - s * n.y, s * n.x + c * n.y, n.z};
    const Vector3d e = T_palm_joint_[point.joint] * point.p_joint / profile_.radius - t;
    if (std::abs(radius_left) <= rounding) {
      doubtful_.push_back({point.weight, dot(e, e)});
      continue;
    }
    weight += point.weight * share;
    sum += point.weight * share * dot(e, e);
    // d share / d delta_r = 12 u (1 - u): by this the weight and the sum change with the displacement
    const double change = hard ? 0 : point.weight * 12 * u * (1 - u);
    steepness += change;
    pull += change * dot(e, e);
  }
  if (!hard && weight > 0) doubtful_.clear();  // the share of such a point is nothing beside the others'
  const double mean_square = sum / weight, rms = std::sqrt(mean_square);
  const double slope = rms > 0 ? 1 + (pull + steepness * mean_square) / weight / (2 * rms) : 1;
  return {.low = extreme_rms(weight, sum, -1),
          .high = extreme_rms(weight, sum, 1),
          .rounding = rounding * slope,
          .may_be_nothing = !(weight > 0)};
}

// the least or greatest mean: a doubtful point counts when it leads there
double ResidualCheck::extreme_rms(double weight, double sum, int sign) {
  std::sort(doubtful_.begin(), doubtful_.end(),
            [&](const Doubtful& a, const Doubtful& b) { return sign * a.square_error > sign * b.square_error; });
  for (const Doubtful& point : doubtful_) {
    if (weight > 0 && sign * (point.square_error - sum / weight) <= 0) break;
    weight += point.weight;
    sum += point.weight * point.square_error;
  }
  return weight > 0 ? std::sqrt(sum / weight) : std::nan("");
}

}  // namespace uhas::test
