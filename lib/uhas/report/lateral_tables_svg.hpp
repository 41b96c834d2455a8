// The lateral look-up tables as a drawing.
#pragma once

#include <string>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// An SVG file: a plot a lateral joint, the azimuth of its fingertip (degrees, canonical) over the joint's value
/// (degrees), the neutral value marked. Joints that drive a finger come first, in the order of fingers; those that stay
/// at neutral are said to. A hand without lateral joints says so.
std::string lateral_tables_svg(const HandProfile& profile);

}  // namespace uhas
