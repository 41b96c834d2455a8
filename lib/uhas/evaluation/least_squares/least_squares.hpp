// The least-squares problem that the cascade answers (docs/method.md#targets, docs/method.md#closing), written a second
// time from that page alone: a finger's points, their targets under an action, and the weighted squared distance with
// its derivative.
#pragma once

#include <span>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// A finger, or fingers that share a joint, and the joint values that its points decide.
class LeastSquares {
 public:
  /// The problems of a hand: every finger is part of one. Fingers without a point or an unknown have none.
  static std::vector<LeastSquares> of_hand(const HandProfile& profile);

  const std::vector<int>& fingers() const { return fingers_; }
  const std::vector<int>& unknowns() const { return unknowns_; }  ///< independent encompassing joints

  /// Sets the targets. `action`: [15], default driving vectors, reading `finger`, closing `fade`.
  void set_action(std::span<const double> action);

  /// Sum over the points of weight times what closing has left of each.
  double weight() const { return weight_; }

  /// Root of the weighted mean square distance of points from targets (sphere radii) at joint values
  /// `q`, mimics applied.
  double rms(std::span<const double> q);

  /// Weighted mean square distance, and its derivative by each unknown when `gradient` is not empty. `q`: all joints of
  /// the profile, in which the unknowns are set to `x` and followers follow.
  double mean_square(std::span<double> q, std::span<const double> x, std::span<double> gradient);

 private:
  explicit LeastSquares(const HandProfile& profile) : profile_(&profile) {}

  struct Point {
    int joint, finger;
    Vector3d p_joint;        // in the joint's moved frame, m
    double theta, phi, rho;  // canonical azimuth, polar angle, rest radius
    double weight;
    Vector3d t_palm{};  // target, m
    double share = 1;   // what closing has left
  };

  void add_points();
  void place(std::span<const double> q);

  const HandProfile* profile_;
  std::vector<int> fingers_, unknowns_;
  std::vector<int> joints_;  // increasing, parents included
  std::vector<Point> points_;
  std::vector<RigidTransformd> T_palm_joint_;  // [joint of the profile]
  double weight_ = 0;
};

}  // namespace uhas
