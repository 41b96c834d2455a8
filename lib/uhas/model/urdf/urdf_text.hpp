// The text of a URDF, checked and reduced before urdfdom sees it.
#pragma once

#include <cstdint>
#include <string>

namespace uhas {

/// Reduces a URDF to links with their shapes and joints with their kinematics, so that what a hand model does not need
/// (inertias, materials, transmissions, sensors) cannot make urdfdom drop what it does need.
/// A capsule is passed on as a cylinder; the `name` of every visual and collision becomes the tag of its shape, which
/// tells the two apart.
/// Throws Error: syntax (not XML, no URDF, unexpanded xacro), invalid_model (the links are no tree), limit_exceeded
/// (nesting or a tag beyond any real URDF, more than `max_links` links).
std::string reduce_urdf(const std::string& text, const std::string& file, std::uint64_t max_links);

}  // namespace uhas
