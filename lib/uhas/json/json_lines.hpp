// JSON Lines: one document a line, read one at a time, and a conversation of such lines.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

#include "uhas/json/json_text.hpp"

namespace uhas {

/// Reads lines in constant memory, a line of at most 1 MiB; blank ones are passed over.
class JsonLines {
 public:
  /// `in` must outlive this.
  explicit JsonLines(std::istream& in) : in_(in) {}

  /// Goes to the next line that holds something; false at the end.
  bool next();

  /// What the line holds. Throws Error: limit_exceeded for a line over 1 MiB, syntax.
  Json document() const;

  std::size_t number() const { return number_; }            ///< of the line, counted from 1
  std::uint64_t bytes_read() const { return bytes_read_; }  ///< of all lines so far

 private:
  bool read_line();

  std::istream& in_;
  std::string line_;  // one byte longer than is allowed for any line that is too long
  std::size_t number_ = 0;
  std::uint64_t bytes_read_ = 0;
};

/// Answers each line of `in` by one line on `out`, flushed at once. A line over 1 MiB, one that is not JSON, or one for
/// which `answer` throws Error, is answered by {"error": ..., "line": n}, n counted from 1. Returns how many lines were
/// answered so. Throws Error(write_failed) when `out` takes no more.
std::size_t answer_json_lines(std::istream& in, std::ostream& out, const std::function<Json(const Json&)>& answer);

}  // namespace uhas
