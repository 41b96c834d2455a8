// Work that a hostile file may bring down, done in a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/fence/child_limits.hpp"

namespace uhas {

/// Work in a copy of this process: whatever it does to memory is undone with the copy, and a crash, a hang or boundless
/// memory there is an Error here. It is a fence against mishap, not a jail: the copy may still read files and talk to
/// the world, though it can write no file. For set-up code; while the copy is made, no other thread may hold a lock
/// that the work needs.
class ChildProcess {
 public:
  /// Begins `work(0)`, `work(1)`, ... up to `count`; it runs ahead of who asks for the results as far as a pipe holds.
  /// @param blame  the code of the error for a copy that crashes
  /// @param file   what the work reads, for errors. Throws Error(file_unreadable) when no process can be made.
  ChildProcess(const ChildLimits& limits, ErrorCode blame, const std::string& file, std::size_t count,
               std::function<std::vector<std::byte>(std::size_t i)> work);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();  ///< ends the copy

  /// The next result; `file` is what it was read from, for errors.
  /// Throws what the work throws (an Error with its code, everything else as `blame`); Error: `blame`, limit_exceeded.
  std::vector<std::byte> next(const std::string& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What `work` returns, found in a copy of this process. Throws what ChildProcess throws.
std::vector<std::byte> in_child(const ChildLimits& limits, ErrorCode blame, const std::string& file,
                                const std::function<std::vector<std::byte>()>& work);

}  // namespace uhas
