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
  correspondence = 0,  ///< least squares over the surface points the joint carries
  contact = 1,         ///< turn from open to the first contact of the next joint with the deformed profile
};

/// What a joint does as its points' spheres shrink past the centre.
enum class CascadeClosing : int {
  fade = 0,  ///< blends toward the closed end as the sphere radius falls from 0.5 to 0
  hard = 1,  ///< drops points of negative sphere radius; a joint with none left closes (the paper's)
};

/// Which deformation a surface point takes.
enum class FieldReading : int {
  finger = 0,  ///< that of its own finger's plane: fingers are independent
  field = 1,   ///< the field interpolated between planes at the point's own azimuth
};

struct SolveOptions {
  CascadeRule rule = CascadeRule::correspondence;
  CascadeClosing closing = CascadeClosing::fade;
  FieldReading field = FieldReading::finger;
  int passes = 1;                 ///< 1..100: sweeps over each finger; more come nearer to the least-squares optimum
  ActionConvention convention{};  ///< what the numbers of an action mean
};

/// uhas' own convention, and that of the authors' released simulation code with the rule and closing of its controller:
/// radii instead of displacements, held toward the pole, azimuth about the opposite normal. By its description only:
/// not yet compared with output of that code. Its sphere is smaller: build the profile with radius scale 0.8.
inline constexpr SolveOptions kUhas{};
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
};

/// Solves one hand. Copies share the constant model and have scratch memory of their own: give each thread its copy.
template <class Real>
class UHAS_API CascadeSolver {
 public:
  /// Throws Error: invalid_profile for a profile that `validate_profile` refuses, invalid_action for passes or numbers
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
