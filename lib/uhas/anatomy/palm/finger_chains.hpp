// Which rigid group of the model is the palm, and which chains of joints are its fingers (docs/method.md#anatomy, "Palm
// and fingers").
// A rigid group is what one movable joint carries without another joint between; group -1 hangs on the root link.
#pragma once

#include <vector>

#include "uhas/anatomy/hand_config.hpp"
#include "uhas/model/hand_model.hpp"

namespace uhas {

struct FingerChains {
  int palm_link = -1;                    ///< index into `HandModel::links`
  int palm_group = -1;                   ///< movable joint that carries the palm; -1 = the root link's group
  std::vector<std::vector<int>> chains;  ///< joints of `HandModel::tree`, root to tip, in the model's order
  double palm_margin = 1;                ///< 0..1: how clearly the chains meet in this group and in no other
  double chain_margin = 1;               ///< 0..1: how clearly each branch is a finger, or is none
};

/// Finds the group in which the significant chains meet, and the chains on it; takes what the config states of either.
/// Throws Error(invalid_hand) when fewer than two fingers hang on the palm, Error(invalid_config) for what
/// the model lacks.
FingerChains find_finger_chains(const HandModel& model, const HandConfig& config = {});

}  // namespace uhas
