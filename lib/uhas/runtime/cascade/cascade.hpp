// The working half of the solver: the state of one solve and the steps of the cascade, in the order they run.
// The source files that choose a number type include cascade_kernel.hpp, which holds the definitions, and for plain
// numbers point_targets.hpp and contact_rule.hpp.
#pragma once

#include <span>
#include <vector>

#include "uhas/runtime/cascade/moments.hpp"
#include "uhas/runtime/cascade/patch_moments.hpp"
#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {

/// Everything a solve writes, sized once; running it allocates nothing. Joint values are in solver units.
/// @tparam Num   float or double for one hand, Lanes for as many hands as it has lanes. No lane depends on another.
/// @tparam Visit  called for a patch that fades: visit(columns, profile, closing), its moments point by point
/// The rule `contact` and the field reading `field` need a plain number.
template <class Num, class Visit>
class Cascade {
 public:
  using Real = LaneReal<Num>;
  using Mask = MaskOf<Num>;
  using Model = SolverModel<Real>;
  using Pass = SolverPass<Real>;

  explicit Cascade(const Model& model, Visit visit = {});

  /// Before the parts are run: what the deformations in `planes` say of the whole hand.
  void begin(const Model& model) noexcept;

  /// From the deformations in `planes` to the joint values and flags of a part.
  void run(const Model& model, const SolverPart& part) noexcept;

  /// The first half of the first pass over a part that is one chain: what its joints carry, with targets that the
  /// azimuth has not turned.
  void carry(const Model& model, const SolverPart& part) noexcept {
    begin_joints(model, part);
    sum_targets(model, part, false);
    carry_moments(model, part.tree, model.passes.front());
  }
  const PointMoments<Num>& carried(int joint) const noexcept { return joints_[joint].carried; }

  /// All frames at the joint values `q` [joint] (profile units), closing included. Plain numbers only.
  void place_joints(const Model& model, std::span<const Num> q) noexcept;
  const RigidTransform<Num>& frame(int joint) const noexcept { return joints_[joint].T_S_moved; }

  /// How far the points are from their targets, in the frames that `place_joints` has set. Plain numbers only.
  SquaredErrors squared_errors(const Model& model) const noexcept;

  const Num& q(int joint) const noexcept { return joints_[joint].q; }
  const Mask& at_limit(int joint) const noexcept { return joints_[joint].at_limit; }
  const Mask& closed(int joint) const noexcept { return joints_[joint].closed; }

  std::vector<PlaneDeformation<Num>> planes;  ///< [finger] in

 private:
  struct JointState {
    JointValue<Num> value;          // the cascade's own, before closing
    bool at_start;                  // `value` is the joint's start
    RigidTransform<Num> T_S_moved;  // moved frame in S
    PointMoments<Num> own;          // of the points on the joint's links
    PointMoments<Num> carried;      // own and all further out, decayed, in the joint's moved frame
    Num open_share{1};              // of a step: what closing has left of the weight it carries
    Num q;                          // out
    Mask at_limit, closed;          // out

    void set(const JointValue<Num>& v) { value = v, at_start = false; }
  };

  /// A fitted value within limits, and where it was held at one.
  struct Fit {
    JointValue<Num> value;
    Mask at_limit;
  };

  /// Minus half the first and second derivative of the weighted squared distance.
  struct Descent {
    Num slope, bend;
  };

  /// Where a material point must go, and how much of it closing has left.
  struct Target {
    Vector3<Num> t;
    Num share;
  };

  // cascade_kernel.hpp
  const PlaneDeformation<Num>& plane_of(const Model& model, int finger) const noexcept;
  void begin_joints(const Model& model, const SolverPart& part) noexcept;
  void sum_targets(const Model& model, const SolverPart& part, bool turned) noexcept;
  void sweep(const Model& model, const SolverPart& part, const Pass& pass) noexcept;
  void carry_moments(const Model& model, std::span<const ScopedJoint> scope, const Pass& pass) noexcept;
  RigidTransform<Num> frame_before_motion(const Model& model, int joint) const noexcept;
  void move_frames(const Model& model, std::span<const ScopedJoint> scope) noexcept;
  void solve_step(const Model& model, const SolverStep& step, const RigidTransform<Num>& F, const Pass& pass) noexcept;
  Fit fit_step(const Model& model, const SolverStep& step, const RigidTransform<Num>& F, const Pass& pass) noexcept;
  Fit fit_single(const Model& model, const SolverStep& step, const RigidTransform<Num>& F,
                 const Pass& pass) const noexcept;
  Fit within_limits(const SolverJoint<Real>& joint, const JointValue<Num>& value) const noexcept;
  void set_unknown(const Model& model, const SolverStep& step, const JointValue<Num>& value) noexcept;
  void close_faded(const Model& model, const SolverPart& part) noexcept;

  // coupled_joints.hpp
  Fit fit_group(const Model& model, const SolverStep& step, const Pass& pass) noexcept;
  Descent descent(const Model& model, const SolverStep& step, const JointValue<Num>& value, const Pass& pass) noexcept;

  // point_targets.hpp
  void average_planes(const Model& model) noexcept;
  Target target_of(const Model& model, const SolverPoint<Real>& point) const noexcept;
  void sum_points(const Model& model) noexcept;

  // contact_rule.hpp
  Num contact_single(const Model& model, const SolverStep& step, const RigidTransform<Num>& F) noexcept;
  Num contact_group(const Model& model, const SolverStep& step) noexcept;
  Vector3<Num> node_in_frame(const Model& model, const ContactNode& node, int joint) const noexcept;

  Visit visit_;
  std::vector<PlaneDeformation<Num>> group_planes_;  // [group of planes] mean of its fingers
  std::vector<JointState> joints_;                   // [joint]
};

}  // namespace uhas
