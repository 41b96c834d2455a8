// Where a finger ends.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "uhas/anatomy/palm/palm_tree.hpp"

namespace uhas {

struct Fingertip {
  int link = -1;                       ///< index into `PalmTree::links`
  Vector3d p_link;                     ///< in that link's frame (m)
  std::optional<Vector3d> pad_normal;  ///< outward, any length, in that link's frame; only where the config states it
  std::string reason;
  double confidence = 1;
};

/// One element a finger: what the config states of it; else the tip frame when there is one, else the far end of the
/// surface of the last rigid group, else the end of a phalanx as long as the one before.
/// Throws Error(invalid_config) for an unknown link, one that no finger's last joint carries, two tips of one finger.
std::vector<Fingertip> find_fingertips(const HandModel& model, const PalmTree& palm, const HandConfig& config = {});

/// The finding "fingertips": that of the least certain one.
HandFinding explain_fingertips(std::span<const Fingertip> tips);

}  // namespace uhas
