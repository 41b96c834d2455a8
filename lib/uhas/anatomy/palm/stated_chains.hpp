// The finger chains and the palm that a hand config states.
#pragma once

#include <vector>

#include "uhas/anatomy/hand_config.hpp"
#include "uhas/model/hand_model.hpp"

namespace uhas {

/// Index of the link that the config names as the palm. Throws Error(invalid_config) with the nearest link
/// of the model.
int find_stated_palm_link(const HandModel& model, const HandConfig& config);

/// The fingers that the config states, as joints of the model; the palm is the group on which they begin.
struct StatedChains {
  std::vector<std::vector<int>> chains;  ///< root to tip
  int palm_group = -1;                   ///< movable joint that carries every first joint; -1 = the root link's group
};

/// Throws Error(invalid_config) for an unknown joint, a chain with a gap, chains that begin on different groups, a
/// last joint that another chain has too, fewer than two chains.
StatedChains find_stated_chains(const HandModel& model, const HandConfig& config);

}  // namespace uhas
