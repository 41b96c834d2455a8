// Rows that threads take a chunk at a time, until none is left: a thread that is slow takes fewer.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace uhas {

class RowChunks {
 public:
  static constexpr std::size_t kRows = 64;  ///< of a chunk

  struct Chunk {
    std::size_t begin, end;
    bool empty() const noexcept { return begin == end; }
  };

  /// To be called while no thread takes rows.
  void start(std::size_t count) noexcept {
    count_ = count;
    next_.store(0, std::memory_order_relaxed);
  }

  /// The next rows that no thread has taken; empty when there are none.
  Chunk take() noexcept {
    const std::size_t begin = std::min(next_.fetch_add(kRows, std::memory_order_relaxed), count_);
    return {begin, std::min(begin + kRows, count_)};
  }

 private:
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
};

}  // namespace uhas
