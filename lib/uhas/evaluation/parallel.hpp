// Independent pieces of work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace uhas {

/// Calls `work(k)` once for each k = 0 .. count - 1, on `threads` threads, in no particular order. A piece
/// writes nothing that another one reads, so that results do not depend on the number of threads. Rethrows the
/// first exception seen.
/// @param make_worker  called once a thread: returns the function `work`, with scratch memory of its own
template <class MakeWorker>
void parallel_for(int count, int threads, const MakeWorker& make_worker) {
  std::atomic<int> next = 0;
  std::vector<std::exception_ptr> failures(std::clamp(threads, 1, std::max(count, 1)));
  const auto run = [&](std::exception_ptr& failure) {
    try {
      auto work = make_worker();
      for (int k = next++; k < count; k = next++) work(k);
    } catch (...) {
      failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < failures.size(); ++t) others.emplace_back([&, t] { run(failures[t]); });
    run(failures[0]);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace uhas
