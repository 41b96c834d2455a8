// The working half of the solver: the state of one solve and the steps of the cascade, in the order they run.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "uhas/runtime/moments_detail.hpp"
#include "uhas/runtime/solver_model_detail.hpp"

namespace uhas {

/// Everything a solve writes, sized once; running it allocates nothing. Joint values are in solver units.
template <class Real>
class Cascade {
 public:
  explicit Cascade(const SolverModel<Real>& model);

  /// From the deformations in `planes` to joint values in `q` and flags in `at_limit` and `closed`.
  void run(const SolverModel<Real>& model) noexcept;

  /// Weighted rms distance of the points from their targets at `q`, sphere radii; NaN when closing has dropped every point.
  double residual_rms(const SolverModel<Real>& model) noexcept;

  std::vector<PlaneDeformation<Real>> planes;  ///< [finger] in
  std::vector<Real> q;                         ///< [joint] out
  std::vector<std::uint8_t> at_limit, closed;  ///< [joint] out

 private:
  /// Where a material point must go, and how much of it closing has left.
  struct Target {
    Vector3<Real> t;
    Real share;
  };

  const PlaneDeformation<Real>& plane_of(const SolverModel<Real>& model, int finger) const noexcept;
  void average_planes(const SolverModel<Real>& model) noexcept;
  void begin_joints(const SolverModel<Real>& model) noexcept;
  Target target_of(const SolverModel<Real>& model, const SolverPoint<Real>& point) const noexcept;
  void sum_targets(const SolverModel<Real>& model) noexcept;
  PointMoments<Real> moments_of(const SolverModel<Real>& model, const SolverPatch<Real>& patch) const noexcept;

  void set_joint(const SolverModel<Real>& model, int joint, const JointValue<Real>& value) noexcept;
  void set_unknown(const SolverModel<Real>& model, const SolverStep& step, const JointValue<Real>& value) noexcept;
  void carry_moments(const SolverModel<Real>& model, std::span<const ScopedJoint> scope) noexcept;
  void move_frames(const SolverModel<Real>& model, std::span<const ScopedJoint> scope) noexcept;
  RigidTransform<Real> frame_before_motion(const SolverModel<Real>& model, int joint) const noexcept;

  void sweep(const SolverModel<Real>& model) noexcept;
  void solve_step(const SolverModel<Real>& model, const SolverStep& step) noexcept;
  void close_faded(const SolverModel<Real>& model) noexcept;
  void mark(const SolverStep& step, std::vector<std::uint8_t>& flags, bool value) noexcept;

  JointValue<Real> fit_single(const SolverModel<Real>& model, int joint) const noexcept;
  Real fit_group(const SolverModel<Real>& model, const SolverStep& step) noexcept;
  Real descent(const SolverModel<Real>& model, const SolverStep& step, Real value) noexcept;

  Real contact_single(const SolverModel<Real>& model, const SolverStep& step) noexcept;
  Real contact_group(const SolverModel<Real>& model, const SolverStep& step) noexcept;
  Vector3<Real> node_in_frame(const SolverModel<Real>& model, const ContactNode& node, int joint) const noexcept;

  std::vector<PlaneDeformation<Real>> group_planes_;  // [group of planes] mean of its fingers
  std::vector<JointValue<Real>> values_;              // [joint] the cascade's own values, before closing
  std::vector<RigidTransform<Real>> T_parent_moved_;  // [joint] moved frame in its parent's moved frame
  std::vector<RigidTransform<Real>> T_moved_;         // [joint] moved frame in S
  std::vector<PointMoments<Real>> own_;               // [joint] of the points on the joint's links
  std::vector<PointMoments<Real>> carried_;           // [joint] own and all further out, decayed, in the joint's moved frame
  std::vector<Real> open_share_;                      // [joint] of a step: what closing has left of the weight it carries
  Real decay_{};                                      // of the present pass
};

extern template class Cascade<float>;
extern template class Cascade<double>;

}  // namespace uhas
