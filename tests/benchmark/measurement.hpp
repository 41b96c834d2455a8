// Measuring work against work: everything in one run, a sample of each in turn, so that a drift of the
// machine hits all.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace uhas::benchmark {

using Clock = std::chrono::steady_clock;

/// Time that this process has computed, ns. It stands still while others have the processor, so that a busy machine
/// does not count against what takes longer than a time slice.
double processor_nanoseconds();

struct Summary {
  double median = 0, p99 = 0, worst = 0;  ///< ns
};

/// Median, 99th percentile and maximum of `samples` [n > 0], which are reordered.
Summary summarise(std::span<double> samples);

/// Something that is timed. One sample is one call of `run`, which treats `hands` hands.
struct Work {
  std::string name;
  std::size_t hands = 1;
  std::function<void(std::size_t sample)>
      run;  ///< told the number of the sample, so that it takes other input each time
};

/// Times `rounds` samples of each work, one of each in turn, after one that is not counted.
/// Returns one summary a work: ns of processor time a hand.
std::vector<Summary> measure_in_turn(std::span<const Work> works, int rounds);

/// How evenly single calls run, by the clock on the wall.
struct Tail {
  Summary call;   ///< one call with the clock read before and after it, of the run with the least p99 / median
  Summary clock;  ///< the same loop around nothing: what the clock and the loop cost
};

/// Times `calls` single calls one by one, `runs` times over, and keeps the calmest run.
Tail measure_tail(const std::function<void(std::size_t call)>& work, std::size_t calls, int runs);

}  // namespace uhas::benchmark
