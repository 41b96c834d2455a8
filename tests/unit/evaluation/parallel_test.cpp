#include "uhas/evaluation/parallel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <stdexcept>
#include <vector>

using namespace uhas;

TEST_CASE("every piece is done once, on any number of threads") {
  for (const int threads : {0, 1, 3, 100})
    for (const int count : {0, 1, 50}) {
      std::vector<int> done(count);
      parallel_for(count, threads, [&] { return [&](int k) { ++done[k]; }; });
      CHECK(std::count(done.begin(), done.end(), 1) == count);
    }
}

TEST_CASE("an exception of a piece or of a worker's making reaches the caller, and ends the rest") {
  for (const int threads : {1, 3}) {
    std::atomic<int> begun = 0;
    const auto fail_at_once = [&] {
      return [&](int) {
        ++begun;
        throw std::runtime_error("a piece");
      };
    };
    CHECK_THROWS_WITH_AS(parallel_for(1000, threads, fail_at_once), "a piece", std::runtime_error);
    CHECK(begun <= threads);
    const auto no_worker = []() -> std::function<void(int)> { throw std::runtime_error("a worker"); };
    CHECK_THROWS_WITH_AS(parallel_for(1000, threads, no_worker), "a worker", std::runtime_error);
  }
}
