// The residual of a solution as it is stated (schemas/hand-profile-v1.md, docs/method.md), point by point and in
// double: from profile, action and joint values, by the forward kinematics that KDL has confirmed, and by nothing
// of the solver.
#pragma once

#include <vector>

#include "uhas/runtime/cascade_solver.hpp"

namespace uhas::test {

/// Root mean square distances in sphere radii, NaN when no point is left. `low` and `high` differ where a point
/// stands within rounding of the edge at which it is dropped (closing `hard`), or all that are left do (`fade`): it
/// may count or not.
struct StatedResidual {
  double low, high;
  double rounding;      ///< what rounding may change
  bool may_be_nothing;  ///< NaN is right, too
};

class ResidualCheck {
 public:
  ResidualCheck(const HandProfile& profile, const SolveOptions& options);

  /// @param q        [joint] rad or m
  /// @param epsilon  rounding of a displacement, relative to the largest radius there is
  StatedResidual of(const Action<double>& action, std::span<const double> q, double epsilon);

 private:
  struct Point {
    int joint, finger;
    Vector3d p_joint, direction;  // direction: unit, in S
    double phi, rho, weight;
    int before, after;  // planes of the interpolated field, and the way between them
    double blend;
  };

  /// What the action does in one driving plane.
  struct Plane {
    double delta_theta = 0;
    std::vector<double> phi, delta_r;
    double cosine = 1, sine = 0;  // of delta theta about the sphere's axis

    double at(double angle, bool held_toward_pole) const;
  };

  /// A point at the edge: whether it counts is not told.
  struct Doubtful {
    double weight, square_error;
  };

  void add_points();
  void place_between_planes(Point& point, double theta) const;
  Plane plane_of(const ProfileFinger& finger, const Action<double>& action) const;
  double extreme_rms(double weight, double sum, int sign);
  static Plane mean(const std::vector<Plane>& planes, const std::vector<int>& which);

  const HandProfile& profile_;
  SolveOptions options_;
  std::vector<std::vector<int>> groups_;  // fingers whose planes stand within 5 degrees
  std::vector<double> azimuths_;          // of the groups
  std::vector<Point> points_;
  std::vector<RigidTransformd> T_palm_joint_;
  std::vector<Doubtful> doubtful_;
};

}  // namespace uhas::test
