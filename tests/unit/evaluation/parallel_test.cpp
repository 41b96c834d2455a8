#include <doctest/doctest.h>

#include <functional>
#include <stdexcept>

#include "uhas/evaluation/parallel_detail.hpp"

using namespace uhas;

TEST_CASE("every piece of work is done once, by no more workers than threads") {
  for (int threads : {1, 3, 8})
    for (int count : {0, 1, 5, 1000}) {
      CAPTURE(threads);
      CAPTURE(count);
      std::vector<int> done(count);
      std::atomic<int> workers = 0;
      parallel_for(count, threads, [&] {
        ++workers;
        return [&](int k) { ++done[k]; };
      });
      CHECK(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; }));
      CHECK(workers <= threads);
    }
}

TEST_CASE("what a piece or the making of a worker throws arrives at the caller, and ends the work") {
  for (int threads : {1, 4}) {
    std::atomic<int> done = 0;
    const auto make_worker = [&] {
      return [&](int k) {
        if (k == 10) throw std::runtime_error("piece 10");
        ++done;
      };
    };
    CHECK_THROWS_WITH(parallel_for(1000, threads, make_worker), "piece 10");
    if (threads == 1) CHECK(done == 10);
  }
  const auto make_none = []() -> std::function<void(int)> { throw std::runtime_error("no worker"); };
  CHECK_THROWS_WITH(parallel_for(5, 2, make_none), "no worker");
}
