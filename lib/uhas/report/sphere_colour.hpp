// The colour of a place on the sphere, the same in every picture of a hand.
#pragma once

#include <array>

namespace uhas {

/// Linear red, green and blue, [0, 1]: the hue follows the canonical azimuth `theta` (rad), the lightness falls with
/// the polar angle `phi` (rad) from the palm pole on. All hues have one chroma, so that no azimuth stands out; it fades
/// at the poles, where all azimuths meet.
std::array<double, 3> sphere_colour(double theta, double phi);

/// The same for files that hold sRGB bytes.
std::array<unsigned char, 3> sphere_colour_bytes(double theta, double phi);

}  // namespace uhas
