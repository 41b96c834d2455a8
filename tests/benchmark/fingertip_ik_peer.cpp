#include "fingertip_ik_peer.hpp"

#include <algorithm>

namespace uhas::benchmark {
namespace {

constexpr double kTolerance = 1e-4;  // m
constexpr int kMostSteps = 50;

/// The solution of the symmetric, positive definite system A x = b, A = rows (a0 a1 a2), (a1 a3 a4), (a2 a4 a5).
Vector3d solve_symmetric(const std::array<double, 6>& a, Vector3d b) {
  const double c0 = a[3] * a[5] - a[4] * a[4], c1 = a[2] * a[4] - a[1] * a[5], c2 = a[1] * a[4] - a[2] * a[3];
  const double scale = 1 / (a[0] * c0 + a[1] * c1 + a[2] * c2);
  const double c3 = a[0] * a[5] - a[2] * a[2], c4 = a[1] * a[2] - a[0] * a[4], c5 = a[0] * a[3] - a[1] * a[1];
  return scale *
         Vector3d{c0 * b.x + c1 * b.y + c2 * b.z, c1 * b.x + c3 * b.y + c4 * b.z, c2 * b.x + c4 * b.y + c5 * b.z};
}

/// The step J^T (J J^T + damping)^-1 error of the unknowns that are free: three equations, however many
/// joints there are.
Vector3d damped_error(const Jacobian& J, const std::array<bool, kMostUnknowns>& free, std::size_t unknowns,
                      Vector3d error) {
  // damping that falls with the squared error keeps steps short far away and quadratic convergence near the target
  // (Sugihara, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", 2011)
  const double damping = dot(error, error) + 1e-10;
  std::array<double, 6> A{damping, 0, 0, damping, 0, damping};
  for (std::size_t u = 0; u < unknowns; ++u) {
    if (!free[u]) continue;
    const Vector3d j = J[u];
    A[0] += j.x * j.x, A[1] += j.x * j.y, A[2] += j.x * j.z, A[3] += j.y * j.y, A[4] += j.y * j.z, A[5] += j.z * j.z;
  }
  return solve_symmetric(A, error);
}

/// Steps from `value` toward the target; whether it came there.
bool descend(const PeerFinger& finger, Vector3d target, std::array<double, kMostUnknowns>& value) {
  const std::size_t unknowns = finger.unknowns.size();
  Jacobian J;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector3d error = target - fingertip_with_jacobian(
                                        finger, [&](int u) { return value[u]; }, J);
    if (dot(error, error) < kTolerance * kTolerance) return true;

    // an unknown that would leave its limits is held there, and the others step again without it
    std::array<bool, kMostUnknowns> free;
    free.fill(true);
    for (bool again = true; again;) {
      again = false;
      const Vector3d damped = damped_error(J, free, unknowns, error);
      for (std::size_t u = 0; u < unknowns && !again; ++u) {
        if (!free[u]) continue;
        const double next = value[u] + dot(J[u], damped);
        again = (value[u] <= finger.lower[u] && next < value[u]) || (value[u] >= finger.upper[u] && next > value[u]);
        if (again) free[u] = false;
      }
      if (again) continue;
      for (std::size_t u = 0; u < unknowns; ++u)
        if (free[u]) value[u] = std::clamp(value[u] + dot(J[u], damped), finger.lower[u], finger.upper[u]);
    }
  }
  return false;
}

/// From the last answer; from the middle of the limits when that leads nowhere, for a finger once astray stays there.
void reach_with(const PeerFinger& finger, Vector3d target, std::span<double> q) {
  const std::size_t unknowns = finger.unknowns.size();
  std::array<double, kMostUnknowns> value, middle;
  for (std::size_t u = 0; u < unknowns; ++u) {
    value[u] = q[finger.unknowns[u]];
    middle[u] = (finger.lower[u] + finger.upper[u]) / 2;
  }
  if (!descend(finger, target, value) && descend(finger, target, middle)) value = middle;
  for (std::size_t u = 0; u < unknowns; ++u) q[finger.unknowns[u]] = value[u];
}

}  // namespace

FingertipIkPeer::FingertipIkPeer(const HandProfile& profile) {
  for (std::size_t f = 0; f < profile.fingers.size(); ++f) fingers_.emplace_back(profile, int(f));
}

void FingertipIkPeer::reach(std::span<const double> targets, std::span<double> q) const {
  for (std::size_t f = 0; f < fingers_.size(); ++f)
    reach_with(fingers_[f], {targets[3 * f], targets[3 * f + 1], targets[3 * f + 2]}, q);
}

}  // namespace uhas::benchmark
