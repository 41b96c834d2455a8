// How every tool ends; the man pages say the same.
#pragma once

namespace uhas::tools {

enum class ExitCode : int {
  done = 0,
  run_failed = 1,   ///< the input or the run failed
  wrong_usage = 2,  ///< unknown option, missing argument, impossible combination
};

}  // namespace uhas::tools
