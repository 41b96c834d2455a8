// The rule of refusal of every call for many hands, which `Status` states: row by row.
#pragma once

#include <cstddef>
#include <span>

#include "uhas/base/errors.hpp"

namespace uhas {

/// Calls `run(row)` for row 0 .. count - 1. Returns the first status that is not ok.
/// @param statuses  [count] what became of each row, or empty
template <class Run>
Status each_row(std::size_t count, std::span<Status> statuses, Run&& run) noexcept {
  Status first_refusal = Status::ok;
  for (std::size_t row = 0; row < count; ++row) {
    const Status status = run(row);
    if (!statuses.empty()) statuses[row] = status;
    if (first_refusal == Status::ok) first_refusal = status;
  }
  return first_refusal;
}

/// Whether `statuses` can take those of `count` rows.
inline bool holds_statuses(std::span<const Status> statuses, std::size_t count) noexcept {
  return statuses.empty() || statuses.size() == count;
}

}  // namespace uhas
