// Bounds on the scene of a DAE file, checked before assimp builds it.
#pragma once

#include <string>
#include <string_view>

namespace uhas::detail {

/// A <node> may stand for others (<instance_node>), which stand for others again: from twenty lines assimp makes a
/// million nodes, from a cycle as many as there is stack. This refuses scenes that come to more than 100,000 nodes.
/// @param text  passed by `check_xml_bounds`
/// Throws Error: invalid_mesh, limit_exceeded in the name of `file`.
void check_dae_nodes(std::string_view text, const std::string& file);

}  // namespace uhas::detail
