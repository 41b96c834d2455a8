// The text of a URDF: a model or an Error, and a model goes through every stage.
#include "small_build.hpp"

using namespace uhas;
using namespace uhas::test;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t max_joints = 30;  // keeps an input under a second
  ModelLoadOptions options;
  options.max_triangles = 20'000;
  HandModel model;
  const bool loaded = accepted([&] { model = load_hand_model(input_file("hand.urdf", as_text(data, size)), options); });
  if (loaded && model.tree.joints.size() <= max_joints) build_small(std::move(model), {});
  return 0;
}
