// The palm plane: where the open fingers stand around the palm normal (docs/method.md#the-sphere). Everything here is
// in P.
#pragma once

#include <vector>

#include "uhas/anatomy/anatomy.hpp"

namespace uhas {

struct PalmPlane {
  Vector3d center;              ///< mean of the finger roots: the palm centre
  std::vector<Vector3d> roots;  ///< origin of each finger's first joint
  std::vector<Vector3d> tips;   ///< fingertips in the open pose
  Vector3d x, y;                ///< axes of S in the palm plane
  int thumb_finger = -1;        ///< the thumb; without one, the finger farthest from its neighbours around the normal
  std::vector<double> azimuth;  ///< of each open fingertip about the normal, from x; physical, (-pi, pi]
};

/// @param roots, tips  one element a finger, in the open pose
/// @param thumb, middle  indices of these fingers; -1 = none
PalmPlane measure_palm_plane(std::vector<Vector3d> roots, std::vector<Vector3d> tips, Vector3d palm_normal, int thumb,
                             int middle);

PalmPlane measure_palm_plane(const Anatomy& anatomy);

}  // namespace uhas
