#include "input/collision_input.hpp"

#include "uhas/base/errors.hpp"

namespace uhas::tools {

SelfCollision load_self_collision(Tool& tool, const ProfileFile& file, const ModelInput& input) {
  const std::optional<ModelFile> model = find_models(tool, std::span(&file, 1), input).front();
  if (!model)
    throw Error(
        ErrorCode::file_unreadable, file.path,
        "self-collision needs the hand's meshes, and the URDF that it was built from is neither beside it nor here",
        "name it with --urdf");
  return {file.profile, hand_geometry(file.profile, model->model, model->path)};
}

}  // namespace uhas::tools
