#include "uhas/report/sphere_colour.hpp"

#include <algorithm>
#include <cmath>

namespace uhas {
namespace {

/// Oklab to linear sRGB (B. Ottosson, "A perceptual color space for image processing", 2020).
std::array<double, 3> linear_from_oklab(double lightness, double a, double b) {
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {std::clamp(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, 0.0, 1.0),
          std::clamp(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s, 0.0, 1.0),
          std::clamp(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s, 0.0, 1.0)};
}

}  // namespace

// sphere_map.js has the same numbers
std::array<double, 3> sphere_colour(double theta, double phi) {
  const double lightness = 0.86 - 0.14 * phi, chroma = 0.13 * std::sqrt(std::abs(std::sin(phi))), hue = theta + 0.6;
  return linear_from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

std::array<unsigned char, 3> sphere_colour_bytes(double theta, double phi) {
  std::array<unsigned char, 3> bytes{};
  const std::array<double, 3> linear = sphere_colour(theta, phi);
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = linear[i] <= 0.0031308 ? 12.92 * linear[i] : 1.055 * std::pow(linear[i], 1 / 2.4) - 0.055;
    bytes[i] = static_cast<unsigned char>(std::lround(255 * value));
  }
  return bytes;
}

}  // namespace uhas
