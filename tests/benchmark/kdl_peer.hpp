// The fingers in KDL (Orocos): forward kinematics of each fingertip's chain, and Levenberg-Marquardt from
// the last answer.
#pragma once

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <memory>
#include <span>
#include <vector>

#include "hand_case.hpp"

namespace uhas::benchmark {

class KdlPeer {
 public:
  /// Chains from the palm to each fingertip, as urdfdom reads the URDF; a fixed segment leads from the tip link to the
  /// fingertip where the two differ. KDL knows no mimics: inverse kinematics takes followers for joints of their own.
  explicit KdlPeer(const HandCase& hand);

  /// @param q           [joints] in the profile's order, followers at their masters' bidding
  /// @param fingertips  [fingers][3] m, palm frame
  void fingertips(std::span<const double> q, std::span<double> fingertips);

  /// Turns each finger so that its tip comes to the target, position only, to 0.1 mm; limits are not KDL's business.
  /// @param targets  [fingers][3] m, palm frame
  /// @param q        [joints] the last answer in, the answer out
  void reach(std::span<const double> targets, std::span<double> q);

 private:
  struct Finger {
    KDL::Chain chain;
    std::vector<int> joints;  // profile's index of each of the chain's
    KDL::JntArray q_in, q_out;
    std::unique_ptr<KDL::ChainFkSolverPos_recursive> forward;
    std::unique_ptr<KDL::ChainIkSolverPos_LMA> inverse;
  };
  std::vector<Finger> fingers_;
};

}  // namespace uhas::benchmark
