// The best numerical fingertip inverse kinematics we can write: damped least squares, finger by finger, with limits,
// from the last answer. It places the tips and nothing else.
#pragma once

#include <span>
#include <vector>

#include "peer_jacobian.hpp"

namespace uhas::benchmark {

class FingertipIkPeer {
 public:
  explicit FingertipIkPeer(const HandProfile& profile);

  /// Turns each finger within its limits so that its tip comes to the target, to 0.1 mm, or as near as 50 steps from
  /// the last answer and 50 from the middle of the limits take it.
  /// @param targets  [fingers][3] m, palm frame
  /// @param q        [joints] in the profile's order: the last answer in, the answer out; followers are left alone
  void reach(std::span<const double> targets, std::span<double> q) const;

 private:
  std::vector<PeerFinger> fingers_;
};

}  // namespace uhas::benchmark
