// The open pose: fingers extended in the palm plane, pads toward the palm normal.
#pragma once

#include <span>
#include <vector>

#include "uhas/anatomy/finger_motion_detail.hpp"

namespace uhas {

/// Joint values that open the hand for the palm normal `normal`.
/// @param flexions  one a finger
/// @param q         where the search begins, fingers extended
/// @param held      joints of the tree whose value in `q` stays
std::vector<double> find_open_pose(const Anatomy& anatomy, std::span<const Flexion> flexions, Vector3d normal,
                                   std::vector<double> q, const std::vector<bool>& held);

/// The open pose `q` with the fingers' bases at zero, or else at mid range, where that costs next to nothing. The
/// search above treats side and roll joints so; bases it leaves, for they would turn the palm normal.
std::vector<double> settle_bases(const Anatomy& anatomy, std::span<const Flexion> flexions, Vector3d normal,
                                 std::vector<double> q, const std::vector<bool>& held);

}  // namespace uhas
