// Where results go.
#pragma once

#include <string>

namespace uhas::tools {

/// Writes `text` to the file `path`, which appears whole or not at all. Throws Error(write_failed).
void write_file(const std::string& path, const std::string& text);

/// The same; to standard output when `path` is empty or "-".
void write_result(const std::string& path, const std::string& text);

}  // namespace uhas::tools
