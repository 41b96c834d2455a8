// The pictures of hands that uhas-inspect draws, each to a file.
#pragma once

#include <span>
#include <string>

#include "input/model_input.hpp"

namespace uhas::tools {

/// Where to write what; empty = not asked for.
struct PictureFiles {
  std::string html, glb, ply, svg;

  bool any() const { return !(html.empty() && glb.empty() && ply.empty() && svg.empty()); }
};

/// --html, --gltf, --ply and --svg.
void add_picture_options(Tool& tool, PictureFiles& files);

/// Writes the pictures that are asked for, each whole or not at all, and says so. More than one profile is drawn in
/// HTML only. Throws Error: write_failed, and what `find_models` throws.
void write_pictures(Tool& tool, const PictureFiles& files, std::span<const ProfileFile> profiles,
                    const ModelInput& input);

}  // namespace uhas::tools
