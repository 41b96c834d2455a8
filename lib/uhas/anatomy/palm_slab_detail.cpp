#include "uhas/anatomy/palm_slab_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace uhas {
namespace {

/// A slab is at most this thick for its width (as standard deviations of its surface). Palms of real hands: 0.47 to
/// 0.68; the round base of a gripper: 0.87.
constexpr double kThickest = 0.75;
/// Standard error of a slab's axis (rad): 5 degrees on Shadow, under 1 on other real hands.
constexpr double kSlabError = 0.1;

/// A symmetric matrix by its rows.
using Symmetric = std::array<Vector3d, 3>;

/// Area, first and second moment of a surface about the origin of P.
struct SurfaceMoments {
  double area = 0;
  Vector3d first;
  Symmetric second;

  void add(const std::array<Vector3d, 3>& corner) {
    const double a = norm(cross(corner[1] - corner[0], corner[2] - corner[0])) / 2;
    const Vector3d sum = corner[0] + corner[1] + corner[2];
    area += a;
    first += a / 3 * sum;
    for (const Vector3d& p : {corner[0], corner[1], corner[2], sum}) add_square(a / 12, p);
  }

  Vector3d mean() const { return first / area; }

  Symmetric covariance() const {
    SurfaceMoments about_mean = *this;
    about_mean.add_square(-area, mean());
    for (Vector3d& row : about_mean.second) row = row / area;
    return about_mean.second;
  }

 private:
  void add_square(double weight, Vector3d p) {
    second[0] += weight * p.x * p;
    second[1] += weight * p.y * p;
    second[2] += weight * p.z * p;
  }
};

/// The smallest and the middle eigenvalue of a symmetric matrix C, and the axis of the smallest.
struct ThinAxis {
  double smallest, middle;
  Vector3d axis;  ///< unit; zero when the two are equal
};

/// The eigenvalues of (C - m 1) / p, with m the mean of C's and p such that their squares sum to 6, are 2 cos of three
/// angles a third of a turn apart, and the cosine of three times each is half the determinant (Smith 1961).
ThinAxis find_thin_axis(Symmetric c) {
  const auto subtract = [](Symmetric& matrix, double value) {
    matrix[0].x -= value;
    matrix[1].y -= value;
    matrix[2].z -= value;
  };
  const double mean = (c[0].x + c[1].y + c[2].z) / 3;
  subtract(c, mean);
  const double p = std::sqrt((dot(c[0], c[0]) + dot(c[1], c[1]) + dot(c[2], c[2])) / 6);
  if (!(p > 0)) return {mean, mean, {}};
  const double half_determinant = dot(c[0], cross(c[1], c[2])) / (2 * p * p * p);
  const double angle = std::acos(std::clamp(half_determinant, -1.0, 1.0)) / 3;
  const double largest = 2 * p * std::cos(angle), smallest = 2 * p * std::cos(angle + 2 * std::numbers::pi / 3);
  subtract(c, smallest);  // its rows span what is orthogonal to the axis
  Vector3d axis;
  for (const Vector3d& candidate : {cross(c[0], c[1]), cross(c[1], c[2]), cross(c[2], c[0])})
    if (norm(candidate) > norm(axis)) axis = candidate;
  return {mean + smallest, mean - largest - smallest, normalized(axis)};
}

}  // namespace

std::optional<PalmSlab> find_palm_slab(const HandModel& model, const Anatomy& anatomy, Vector3d knuckle_center) {
  SurfaceMoments moments;
  for (std::size_t i = 0; i < anatomy.links.size(); ++i) {
    if (anatomy.links[i].joint >= 0) continue;
    const TriangleMesh& mesh = model.links[anatomy.model_links[i]].mesh;
    const auto corner = [&](std::uint32_t vertex) { return anatomy.links[i].T_joint_link * mesh.vertices[vertex]; };
    for (const auto& [a, b, c] : mesh.triangles) moments.add({corner(a), corner(b), corner(c)});
  }
  if (!(moments.area > 0)) return std::nullopt;

  const ThinAxis thin = find_thin_axis(moments.covariance());
  if (thin.smallest > kThickest * kThickest * thin.middle) return std::nullopt;
  const Vector3d reach = knuckle_center - moments.mean();
  const double tilt = norm(reach) > 0 ? std::asin(std::min(1.0, std::abs(dot(thin.axis, reach)) / norm(reach))) : 0;
  return PalmSlab{thin.axis, std::max(kSlabError, tilt)};
}

}  // namespace uhas
