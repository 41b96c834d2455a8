#include "uhas/runtime/lanes/worker_pool.hpp"

namespace uhas {

WorkerPool::WorkerPool(int threads) {
  threads_.reserve(threads - 1);
  try {
    for (int worker = 1; worker < threads; ++worker) threads_.emplace_back([this, worker] { work(worker); });
  } catch (...) {
    stop();  // a thread that is not joined ends the program
    throw;
  }
}

WorkerPool::~WorkerPool() { stop(); }

void WorkerPool::stop() noexcept {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  begin_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::run(Task task, void* context) noexcept {
  if (threads_.empty()) return task(context, 0);
  {
    const std::lock_guard lock(mutex_);
    task_ = task;
    context_ = context;
    working_ = static_cast<int>(threads_.size());
    ++round_;
  }
  begin_.notify_all();
  task(context, 0);
  std::unique_lock lock(mutex_);
  end_.wait(lock, [&] { return working_ == 0; });
}

void WorkerPool::work(int worker) noexcept {
  long done = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    begin_.wait(lock, [&] { return stop_ || round_ != done; });
    if (stop_) return;
    done = round_;
    const Task task = task_;
    void* const context = context_;
    lock.unlock();
    task(context, worker);
    lock.lock();
    if (--working_ == 0) end_.notify_one();
  }
}

}  // namespace uhas
