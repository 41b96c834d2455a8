// Fingers as the rest of the hand sees them, made up: only their postures matter.
#pragma once

#include "uhas/anatomy/opening/posture.hpp"

namespace uhas::test {

/// A finger of length 0.1 from `root` along `direction` that closes toward `closing`; unit vectors, orthogonal.
inline FingerPosture make_posture(Vector3d root, Vector3d direction, Vector3d closing) {
  FingerPosture posture;
  posture.root = posture.knuckle = root;
  posture.tip = root + 0.1 * direction;
  posture.direction = direction;
  posture.closing = closing;
  posture.axis = cross(direction, closing);
  return posture;
}

/// Fingers of a right hand with the palm normal +x: `count` along +z, from the index at y = 0 down, and a thumb at the
/// end, on the index's side.
inline std::vector<FingerPosture> make_postures_of_hand(int count, Vector3d thumb_direction = {0, 1, 0}) {
  std::vector<FingerPosture> postures;
  for (int i = 0; i < count; ++i) postures.push_back(make_posture({0, -0.02 * i, 0.08}, {0, 0, 1}, {1, 0, 0}));
  postures.push_back(make_posture({0, 0.02, 0.01}, thumb_direction, {1, 0, 0}));
  return postures;
}

}  // namespace uhas::test
