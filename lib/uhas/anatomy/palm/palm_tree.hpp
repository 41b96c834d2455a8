// The model seen from its palm: a tree of the fingers' joints alone, rooted in the palm link's frame P.
#pragma once

#include <string>
#include <vector>

#include "uhas/anatomy/palm/finger_chains.hpp"

namespace uhas {

struct PalmTree {
  std::string root_link, palm_link;
  RigidTransformd T_root_palm;            ///< joints that are left out at zero, clipped to their limits
  KinematicTree tree;                     ///< joints of the fingers and the masters they mimic, in the model's order
  std::vector<std::string> other_joints;  ///< every other movable joint of the model
  std::vector<ProfileLink> links;         ///< links carried by the palm or by a joint of `tree`
  std::vector<int> model_links;           ///< links[i] is HandModel::links[model_links[i]]
  std::vector<std::vector<int>> chains;   ///< joints of each finger, root to tip: indices into `tree`

  std::vector<HandFinding> findings;  ///< "joint_limits" where the config states some, "palm_link", "fingers"
  std::vector<std::string> warnings;
};

/// Joints left out stand at zero, clipped to their limits, and are folded into those that they carry. A continuous joint
/// gets the limits -+pi; then the limits that the config states are set, and masters narrowed to what their followers
/// can do. Throws Error(invalid_config) for limits of an unknown joint or wider than the joint's.
PalmTree make_palm_tree(const HandModel& model, const FingerChains& found, const HandConfig& config = {});

}  // namespace uhas
