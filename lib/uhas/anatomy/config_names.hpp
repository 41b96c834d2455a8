// The parts of a model that a hand config names.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "uhas/anatomy/hand_config.hpp"
#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// "1 joint", "2 joints".
std::string count_joints(std::size_t count);

/// The unit vector along `direction`. One that is unit already keeps its bits, so that a written config states what
/// was inferred exactly.
Vector3d unit_direction(Vector3d direction);

/// Throws Error(invalid_config): `file: key: problem; remedy`.
[[noreturn]] void refuse_config(const HandConfig& config, const std::string& key, const std::string& problem,
                                const std::string& remedy);

/// Index of the joint `name` that the config names under `key`. Throws Error(invalid_config) with the nearest name.
/// @param lack  what an unknown name means: "no finger has a joint"
int find_joint(const KinematicTree& tree, const std::string& name, const HandConfig& config, const std::string& key,
               const std::string& lack);

/// One element a joint of `tree`: its value in `stated`, the config's `key`, where there is one. Throws
/// Error(invalid_config) for an unknown joint, a mimic follower, or a value outside the joint's limits.
std::vector<std::optional<double>> resolve_joint_values(const KinematicTree& tree,
                                                        const std::map<std::string, double>& stated,
                                                        const HandConfig& config, const std::string& key);

/// Sets the joint limits that the config states. Throws Error(invalid_config) for an unknown joint and for limits that
/// are wider than the joint's.
void narrow_joint_limits(KinematicTree& tree, const HandConfig& config);

}  // namespace uhas
