// Fingers are named by their joints, in findings and in hand configs.
#pragma once

#include <string>

#include "uhas/anatomy/fingers/hand_skeleton.hpp"

namespace uhas {

/// "first joint .. last joint"; "none" for -1.
std::string describe_finger(const HandSkeleton& hand, int finger);

/// The finger of which the config names a joint under `key`; -1 for "", which says that there is none.
/// Throws Error(invalid_config) for a joint that no finger has, or several.
int find_named_finger(const HandSkeleton& hand, const std::string& joint_name, const HandConfig& config,
                      const std::string& key);

}  // namespace uhas
