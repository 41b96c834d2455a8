// Fingers that share a joint: no such finger can be posed without the others.
#pragma once

#include <span>
#include <vector>

namespace uhas {

/// Groups of fingers that have an unknown in common, directly or through others: a palm-arch joint that carries two
/// fingers, or a master that joints of several fingers mimic. A finger that shares nothing is a group of its own.
/// @param unknowns  [finger] the joints that count, as independent joints
/// Returns [group] indices of fingers, the last one first.
std::vector<std::vector<int>> group_fingers(std::span<const std::vector<int>> unknowns);

}  // namespace uhas
