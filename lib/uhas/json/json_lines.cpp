#include "uhas/json/json_lines.hpp"

#include <istream>
#include <ostream>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

constexpr std::size_t kMaxLineBytes = 1u << 20;

}  // namespace

bool JsonLines::next() {
  while (read_line()) {
    ++number_;
    if (line_.size() > kMaxLineBytes || line_.find_first_not_of(" \t\r") != std::string::npos) return true;
  }
  return false;
}

Json JsonLines::document() const {
  if (line_.size() > kMaxLineBytes) throw Error(ErrorCode::limit_exceeded, "", "the line is longer than 1 MiB", "");
  return parse_json(line_, "");
}

/// Up to the line break; false at the end of `in_`.
bool JsonLines::read_line() {
  line_.clear();
  const std::uint64_t before = bytes_read_;
  std::streambuf& buffer = *in_.rdbuf();
  for (int c = buffer.sbumpc(); c != EOF; c = buffer.sbumpc()) {
    ++bytes_read_;
    if (c == '\n') return true;
    if (line_.size() <= kMaxLineBytes) line_.push_back(static_cast<char>(c));
  }
  return bytes_read_ > before;
}

std::size_t answer_json_lines(std::istream& in, std::ostream& out, const std::function<Json(const Json&)>& answer) {
  std::size_t failed = 0;
  for (JsonLines lines(in); lines.next();) {
    Json reply;
    try {
      reply = answer(lines.document());
    } catch (const Error& error) {
      reply = {{"error", error.what()}, {"line", lines.number()}};
      ++failed;
    }
    if (!(out << to_line(reply) << std::flush))
      throw Error(ErrorCode::write_failed, "standard output", "cannot be written", "");
  }
  return failed;
}

}  // namespace uhas
