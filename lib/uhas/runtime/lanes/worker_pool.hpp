// Threads that wait for work: the whole of one batch is shared out to them, and the caller works along.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace uhas {

class WorkerPool {
 public:
  /// Starts `threads` - 1 threads. Throws std::system_error when one cannot be started.
  explicit WorkerPool(int threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  int size() const noexcept { return static_cast<int>(threads_.size()) + 1; }

  /// Calls `task(context, worker)` once for each worker 0 .. size() - 1, worker 0 on the calling thread, and returns
  /// when all are done. `task` must not throw. Allocates nothing; a pool of one takes no lock.
  using Task = void (*)(void* context, int worker);
  void run(Task task, void* context) noexcept;

 private:
  void work(int worker) noexcept;
  void stop() noexcept;

  std::mutex mutex_;
  std::condition_variable begin_, end_;
  Task task_ = nullptr;
  void* context_ = nullptr;
  long round_ = 0;   // of the present batch
  int working_ = 0;  // threads that have not finished it
  bool stop_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace uhas
