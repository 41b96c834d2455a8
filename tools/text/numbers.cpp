#include "text/numbers.hpp"

#include <array>
#include <cstdio>
#include <numbers>

namespace uhas::tools {

std::string fixed(double value, int decimals) {
  std::array<char, 400> text{};  // the largest double has 309 digits before the point
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string result = text.data();
  const bool is_zero = result.find_first_of("123456789in") == std::string::npos;  // "in": inf and nan
  return is_zero && result[0] == '-' ? result.substr(1) : result;
}

std::string degrees(double radians) { return fixed(radians * 180 / std::numbers::pi, 1); }

std::string millimetres(double metres) { return fixed(metres * 1000, 1); }

}  // namespace uhas::tools
