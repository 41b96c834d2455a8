// Where a finger ends.
#pragma once

#include <string>

#include "uhas/anatomy/anatomy.hpp"

namespace uhas {

struct Fingertip {
  int link = -1;    ///< index into `Anatomy::links`
  Vector3d p_link;  ///< in that link's frame (m)
  std::string reason;
  double confidence = 1;
};

/// The tip frame of `finger` when there is one, else the far end of its last rigid group's surface. Reads tree, links
/// and the joints of the finger.
Fingertip find_fingertip(const HandModel& model, const Anatomy& anatomy, const FingerAnatomy& finger);

}  // namespace uhas
