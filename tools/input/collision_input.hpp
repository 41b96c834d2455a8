// The self-collision of a profile's hand, for the tools that offer it.
#pragma once

#include "input/model_input.hpp"
#include "uhas/collision/self_collision.hpp"

namespace uhas::tools {

/// With the meshes of the profile's model. Throws Error: file_unreadable, naming --urdf, when no model is named or
/// nearby; what `find_models` throws.
SelfCollision load_self_collision(Tool& tool, const ProfileFile& file, const ModelInput& input);

}  // namespace uhas::tools
