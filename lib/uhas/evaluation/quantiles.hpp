// What is told of a lot of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace uhas {

/// Zero when there are no values.
struct Quantiles {
  double median = 0, p95 = 0, worst = 0;  ///< worst = greatest
  std::size_t count = 0;
};

/// The least value that at least 50 %, 95 % and all of the values do not exceed.
inline Quantiles quantiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](std::size_t percent) { return values[(values.size() * percent + 99) / 100 - 1]; };
  return {at(50), at(95), values.back(), values.size()};
}

}  // namespace uhas
