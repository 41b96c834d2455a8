#include "measurement.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace uhas::benchmark {

namespace {

double nanoseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

}  // namespace

double processor_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

Summary summarise(std::span<double> samples) {
  std::ranges::sort(samples);
  const std::size_t last = samples.size() - 1;
  return {samples[samples.size() / 2], samples[std::size_t(std::ceil(0.99 * double(last)))], samples[last]};
}

std::vector<Summary> measure_in_turn(std::span<const Work> works, int rounds) {
  std::vector<std::vector<double>> samples(works.size());
  for (int round = -1; round < rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      const double start = processor_nanoseconds();
      works[i].run(std::size_t(round + 1));
      const double elapsed = processor_nanoseconds() - start;
      if (round >= 0) samples[i].push_back(elapsed / double(works[i].hands));
    }
  }
  std::vector<Summary> summaries;
  for (std::vector<double>& of_work : samples) summaries.push_back(summarise(of_work));
  return summaries;
}

Tail measure_tail(const std::function<void(std::size_t)>& work, std::size_t calls, int runs) {
  std::vector<double> samples(calls);
  const auto measure = [&](const std::function<void(std::size_t)>& timed) {
    for (std::size_t i = 0; i < calls; ++i) {
      const auto start = Clock::now();
      timed(i);
      samples[i] = nanoseconds_since(start);
    }
    return summarise(samples);
  };
  Tail tail;
  tail.clock = measure([](std::size_t) {});
  for (int run = 0; run < runs; ++run) {
    const Summary call = measure(work);
    if (run == 0 || call.p99 / call.median < tail.call.p99 / tail.call.median) tail.call = call;
  }
  return tail;
}

}  // namespace uhas::benchmark
