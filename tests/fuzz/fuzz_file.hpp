// What the fuzz targets share: the input as a file, and what may be thrown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "support/scratch_folder.hpp"
#include "uhas/base/errors.hpp"

namespace uhas::test {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A file `name` that holds the input, in a folder of its own.
inline std::string input_file(const std::string& name, std::string_view content) {
  static const ScratchFolder folder;
  return folder.write(name, content);
}

/// Runs `work`, which may refuse its input by an Error; true when it did not. Any other exception ends the process.
template <class Work>
bool accepted(const Work& work) {
  try {
    work();
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Ends the process, for the fuzzer to report its input.
inline void require(bool holds) {
  if (!holds) __builtin_trap();
}

}  // namespace uhas::test
