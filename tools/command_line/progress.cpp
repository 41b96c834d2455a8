#include "command_line/progress.hpp"

#include <unistd.h>

#include <chrono>
#include <iostream>

namespace uhas::tools {
namespace {

constexpr std::chrono::seconds kPatience{1};
constexpr int kBarWidth = 24;

}  // namespace

Progress::Progress(const Tool& tool, int steps) : tool_(tool), steps_(steps) {
  if (tool.quiet() || tool.verbose() || ::isatty(STDERR_FILENO) == 0) return;
  delayed_start_ = std::jthread([this](std::stop_token stop) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, kPatience, [] { return false; });
    if (stop.stop_requested()) return;
    visible_ = true;
    draw();
  });
}

Progress::~Progress() {
  if (!delayed_start_.joinable()) return;
  delayed_start_.request_stop();
  delayed_start_.join();
  if (visible_) std::cerr << "\r\033[K" << std::flush;
}

void Progress::begin(const char* step) {
  tool_.log(step);
  const std::lock_guard lock(mutex_);
  ++current_;
  share_ = 0;
  step_ = step;
  if (visible_) draw();
}

void Progress::advance(double share) {
  const std::lock_guard lock(mutex_);
  const int before = done();
  share_ = share;
  if (visible_ && done() != before) draw();
}

int Progress::done() const { return static_cast<int>(kBarWidth * (std::max(current_ - 1, 0) + share_) / steps_); }

void Progress::draw() const {
  std::cerr << "\r\033[K[" << std::string(done(), '#') << std::string(kBarWidth - done(), '.') << "] " << step_
            << std::flush;
}

}  // namespace uhas::tools
