// What one unknown (a joint with its mimic followers) moves.
#pragma once

#include <vector>

#include "uhas/sphere_frame/sphere_frame.hpp"

namespace uhas {

/// Fingers with a joint that turns with `joint`.
std::vector<int> fingers_moved(const Anatomy& anatomy, int joint);

/// Joints of `finger` further out than the first one that turns with `joint`, those that turn with it left out.
std::vector<int> joints_further_out(const Anatomy& anatomy, int finger, int joint);

}  // namespace uhas
