// Numbers as people read them.
#pragma once

#include <string>

namespace uhas::tools {

/// `value` with `decimals` digits after the point; never "-0".
std::string fixed(double value, int decimals);

/// Radians as degrees with one decimal.
std::string degrees(double radians);

/// Metres as millimetres with one decimal.
std::string millimetres(double metres);

}  // namespace uhas::tools
