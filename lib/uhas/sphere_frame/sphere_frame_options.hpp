// What a user chooses of the sphere frame.
#pragma once

namespace uhas {

struct SphereFrameOptions {
  double radius_scale = 1;  ///< r = radius_scale * 2 l / pi
  /// A five-finger hand averages slots 0 and 1 for ring and pinky (the paper's 4-plane variant).
  bool merge_pinky = false;
};

}  // namespace uhas
