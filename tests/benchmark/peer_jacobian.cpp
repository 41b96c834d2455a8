#include "peer_jacobian.hpp"

#include <algorithm>
#include <stdexcept>

namespace uhas::benchmark {

PeerFinger::PeerFinger(const HandProfile& profile, int finger) : chain(compile_chain<double>(profile, finger)) {
  if (chain.joints.size() > 2 * kMostUnknowns) throw std::runtime_error("a finger of more joints than the peers hold");
  for (const ChainJoint<double>& joint : chain.joints) {
    auto found = std::ranges::find(unknowns, joint.source);
    if (found == unknowns.end()) found = unknowns.insert(unknowns.end(), joint.source);
    unknown_of_joint.push_back(int(found - unknowns.begin()));
  }
  if (unknowns.size() > kMostUnknowns) throw std::runtime_error("a finger of more unknowns than the peers hold");

  for (int unknown : unknowns) {
    lower.push_back(profile.tree.joints[unknown].lower);
    upper.push_back(profile.tree.joints[unknown].upper);
  }
}

}  // namespace uhas::benchmark
