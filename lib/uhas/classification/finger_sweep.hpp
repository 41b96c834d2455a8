// Sweeping one unknown (a joint with its mimic followers) and watching the fingertips it moves, in S.
#pragma once

#include <span>
#include <vector>

#include "uhas/sphere_frame/sphere_frame.hpp"

namespace uhas {

/// Whether joint `other` follows `joint` (or is it).
bool turns_with(const KinematicTree& tree, int other, int joint);

/// Fingers with a joint that turns with `joint`.
std::vector<int> fingers_moved(const Anatomy& anatomy, int joint);

/// `q` with `joint` at `value` and its followers after it.
void set_with_followers(const KinematicTree& tree, int joint, double value, std::span<double> q);

/// Joints of `finger` further out than the first one that turns with `joint`, those that turn with it left out.
std::vector<int> joints_further_out(const Anatomy& anatomy, int finger, int joint);

}  // namespace uhas
