// Rows of a batch between a wide kernel and the code of single calls.
#pragma once

#include <algorithm>

#include "uhas/base/each_row.hpp"

namespace uhas {

/// Leads the rows that a wide kernel takes to it, in runs as long as may be, and each of the others to the code of a
/// single call: no row's result depends on its neighbours. Returns the first status that is not ok.
/// @param statuses  [count] or empty
/// @param takes     takes(first, count): whether the kernel takes these rows
/// @param wide      wide(first, count): the kernel does them
/// @param single    single(row): a Status
template <class Takes, class Wide, class Single>
Status wide_rows(std::size_t count, std::span<Status> statuses, Takes takes, Wide wide, Single single) noexcept {
  // the rule: it takes them all
  if (takes(0, count)) {
    wide(0, count);
    std::fill(statuses.begin(), statuses.end(), Status::ok);
    return Status::ok;
  }
  std::size_t run = 0;  // first row of the present one
  const auto end_run = [&](std::size_t end) {
    if (end > run) wide(run, end - run);
    run = end + 1;
  };
  const Status status = each_row(count, statuses, [&](std::size_t row) {
    if (takes(row, 1)) return Status::ok;
    end_run(row);
    return single(row);
  });
  end_run(count);
  return status;
}

}  // namespace uhas
