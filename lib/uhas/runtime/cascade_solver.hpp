// Cascade Inverse Kinematics (paper, section 3.4 and appendix A; docs/method.md#the-cascade): a deformed sphere
// becomes joint angles.
//
//   uhas::CascadeSolver<double> solver(uhas::read_profile("hand.h5"));
//   std::vector<double> q(solver.joint_count());
//   uhas::Status status = solver.solve({.values = action}, q);
//
// Constructing may throw and allocates; solving does neither, takes no lock and reads no clock.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "uhas/base/errors.hpp"
#include "uhas/base/export.hpp"
#include "uhas/runtime/action.hpp"

namespace uhas {

template <class Real>
struct SolverModel;  // private

/// How a joint angle follows from the deformed sphere.
enum class CascadeRule : int {
  /// Least squares over the surface points the joint carries. Use this when nothing speaks against it: motion is smooth,
  /// and batches use SIMD.
  correspondence = 0,
  /// Turn from open to the first contact of the next joint with the deformed profile. Use this for policies that were
  /// trained with it: joints may jump, and batches solve row by row.
  contact = 1,
};

/// What a joint does as its points' spheres shrink past the centre.
enum class CascadeClosing : int {
  /// Blends toward the closed end as the sphere radius falls from 0.5 to 0. Use this for motion without jumps.
  fade = 0,
  /// Drops points of negative sphere radius; a joint with none left closes at once (the paper's). Use this for policies
  /// that were trained with it, and to compare with the paper.
  hard = 1,
};

/// Which deformation a surface point takes.
enum class FieldReading : int {
  /// That of its own finger's plane. Use this when a finger is to do what its own numbers say: fingers are independent.
  finger = 0,
  /// The field interpolated between planes at the point's own azimuth (the paper's). Use this to compare with the paper:
  /// neighbours pull at each other near the palm, and batches solve row by row.
  field = 1,
};

struct SolveOptions {
  CascadeRule rule = CascadeRule::correspondence;
  CascadeClosing closing = CascadeClosing::fade;
  FieldReading field = FieldReading::finger;
  /// 1 to 100: sweeps over each finger. Use one in a control loop; more come nearer to the least-squares optimum, take
  /// longer and are less smooth.
  int passes = 1;
  ActionConvention convention{};  ///< what the numbers of an action mean
};

/// uhas' own convention. Use this for all that is new.
inline constexpr SolveOptions kUhas{};

/// The convention of the authors' released simulation code, with the rule and closing of its controller: radii instead of
/// displacements, held toward the pole, azimuth about the opposite normal. Use this for policies trained with that code.
/// By its description only: not yet compared with output of that code. Its sphere is smaller: build the profile with
/// radius scale 0.8.
inline constexpr SolveOptions kUhasSim{
    .rule = CascadeRule::contact,
    .closing = CascadeClosing::hard,
    .convention = {.absolute_radii = true, .held_toward_pole = true, .azimuth_sign = -1}};

/// What a solve found out besides the joint angles. The spans are caller-owned, one element a joint, or empty.
struct SolveReport {
  double residual_rms = 0;  ///< root of the weighted mean square distance of points from targets, sphere radii;
                            ///< NaN when every point has been dropped
  std::span<std::uint8_t> at_limit;  ///< 1 where the fitted angle was held at a limit
  std::span<std::uint8_t> closed;    ///< 1 where the joint closed because no point was left
  bool clamped = false;              ///< a number of the action was beyond its bounds (`action_bounds`) and was clamped
};

/// Solves one hand. Copies share the constant model and have scratch memory of their own: give each thread its copy.
template <class Real>
class UHAS_API CascadeSolver {
 public:
  /// Throws Error: invalid_profile for a profile that `validate_profile` refuses, invalid_option for passes or numbers
  /// of the convention out of range.
  explicit CascadeSolver(const HandProfile& profile, const SolveOptions& options = {});
  CascadeSolver(const CascadeSolver& other);
  CascadeSolver& operator=(const CascadeSolver& other);
  CascadeSolver(CascadeSolver&&) noexcept;
  CascadeSolver& operator=(CascadeSolver&&) noexcept;
  ~CascadeSolver();

  int joint_count() const noexcept;  ///< length of q: every joint of the profile, mimic followers included

  /// Joint angles (rad; m for prismatic joints) in the profile's joint order, within limits for any finite input.
  /// On any status but ok the output is untouched.
  Status solve(const Action<Real>& action, std::span<Real> q) noexcept;

  /// The same, and a report.
  Status solve(const Action<Real>& action, std::span<Real> q, SolveReport& report) noexcept;

 private:
  struct UHAS_PRIVATE Scratch;
  std::shared_ptr<const SolverModel<Real>> model_;
  std::unique_ptr<Scratch> scratch_;
};

extern template class CascadeSolver<float>;
extern template class CascadeSolver<double>;

}  // namespace uhas
