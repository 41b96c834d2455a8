// Where a finger ends.
#pragma once

#include <string>
#include <vector>

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
/// @param stated  what the config says of this tip, checked; null = nothing
Fingertip find_fingertip(const HandModel& model, const Anatomy& anatomy, const FingerAnatomy& finger,
                         const StatedFingertip* stated = nullptr);

/// What the config states of each finger's tip, one element a finger; null where it states nothing.
/// Throws Error(invalid_config) for an unknown link, one that no finger's last joint carries, two tips of one finger.
std::vector<const StatedFingertip*> find_stated_fingertips(const Anatomy& anatomy, const HandConfig& config);

}  // namespace uhas
