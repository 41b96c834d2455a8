// A conversation in JSON Lines: one document in, one document out.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "uhas/json/json_text.hpp"

namespace uhas {

inline constexpr std::size_t kMaxLineBytes = 1u << 20;

/// Reads up to the line break, at most one byte more than `kMaxLineBytes` of it; false at the end of `in`.
bool read_line(std::istream& in, std::string& line);

/// Answers each line of `in` by one line on `out`, flushed at once. A line over 1 MiB, or one for which `answer` throws
/// Error, is answered by {"error": ..., "line": n}, n counted from 1. Returns how many lines were answered so.
/// Throws Error(write_failed) when `out` takes no more.
std::size_t answer_json_lines(std::istream& in, std::ostream& out,
                              const std::function<Json(const std::string& line)>& answer);

}  // namespace uhas
