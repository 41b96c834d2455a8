#include "uhas/anatomy/palm/palm_slab.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace uhas {
namespace {

/// A slab is at most this thick for its width (as standard deviations of its surface). Palms of real hands: 0.47 to
/// 0.68; the round base of a gripper: 0.87.
constexpr double kThickest = 0.75;
/// Standard error of a slab's axis (rad): 5 degrees on Shadow, under 1 on other real hands.
constexpr double kSlabError = 0.1;

Eigen::Vector3d to_eigen(Vector3d v) { return {v.x, v.y, v.z}; }

/// Area, first and second moment of a surface about the origin of P, exact for flat triangles: over a triangle of area
/// a with corners p and their sum s, the integral of x is a s / 3, that of x x^T is a (sum of p p^T + s s^T) / 12.
struct SurfaceMoments {
  double area = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const std::array<Eigen::Vector3d, 3>& corner) {
    const double a = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() / 2;
    const Eigen::Vector3d sum = corner[0] + corner[1] + corner[2];
    area += a;
    first += a / 3 * sum;
    for (const Eigen::Vector3d& p : corner) second += a / 12 * p * p.transpose();
    second += a / 12 * sum * sum.transpose();
  }

  Eigen::Vector3d mean() const { return first / area; }
  Eigen::Matrix3d covariance() const { return second / area - mean() * mean().transpose(); }
};

}  // namespace

std::optional<PalmSlab> find_palm_slab(const HandModel& model, const PalmTree& palm, Vector3d knuckle_center) {
  // moments of the surface of the palm's rigid group
  SurfaceMoments moments;
  for (std::size_t i = 0; i < palm.links.size(); ++i) {
    if (palm.links[i].joint >= 0) continue;
    const TriangleMesh& mesh = model.links[palm.model_links[i]].mesh;
    const auto corner = [&](std::uint32_t vertex) {
      return to_eigen(palm.links[i].T_joint_link * mesh.vertices[vertex]);
    };
    for (const auto& [a, b, c] : mesh.triangles) moments.add({corner(a), corner(b), corner(c)});
  }
  if (!(moments.area > 0)) return std::nullopt;

  // a slab is much thinner along one principal axis than along the next
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.covariance());  // thinnest first
  if (axes.eigenvalues()[0] > kThickest * kThickest * axes.eigenvalues()[1]) return std::nullopt;

  // the way from its middle to the knuckles lies in it: what it leaves that way by is its error
  const Eigen::Vector3d thinnest = axes.eigenvectors().col(0);
  const Eigen::Vector3d reach = to_eigen(knuckle_center) - moments.mean();
  const double tilt = reach.norm() > 0 ? std::asin(std::min(1.0, std::abs(thinnest.dot(reach)) / reach.norm())) : 0;
  return PalmSlab{{thinnest.x(), thinnest.y(), thinnest.z()}, std::max(kSlabError, tilt)};
}

}  // namespace uhas
