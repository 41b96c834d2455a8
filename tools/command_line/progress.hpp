// A progress bar on stderr: only on a terminal, only once the work has taken a second.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "command_line/tool.hpp"

namespace uhas::tools {

class Progress {
 public:
  /// @param steps  how often `begin` will be called
  Progress(const Tool& tool, int steps);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Clears the bar.
  ~Progress();

  /// The next step begins. With --verbose it is logged instead of drawn.
  void begin(const char* step);

  /// The present step has done this share of its work, 0 to 1.
  void advance(double share);

 private:
  int done() const;  // how much of the bar
  void draw() const;

  const Tool& tool_;
  const int steps_;
  int current_ = 0;
  double share_ = 0;  // of the present step
  std::string step_;
  bool visible_ = false;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::jthread delayed_start_;  // last: it uses the members above
};

}  // namespace uhas::tools
