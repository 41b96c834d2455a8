#include "uhas/json/json_lines.hpp"

#include <istream>
#include <ostream>

#include "uhas/base/errors.hpp"

namespace uhas {
bool read_line(std::istream& in, std::string& line) {
  line.clear();
  std::streambuf& buffer = *in.rdbuf();
  for (int c = buffer.sbumpc(); c != EOF; c = buffer.sbumpc()) {
    if (c == '\n') return true;
    if (line.size() <= kMaxLineBytes) line.push_back(static_cast<char>(c));
  }
  return !line.empty();
}

std::size_t answer_json_lines(std::istream& in, std::ostream& out,
                              const std::function<Json(const std::string& line)>& answer) {
  std::size_t failed = 0;
  std::string line;
  for (std::size_t number = 1; read_line(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;  // a blank line asks nothing
    Json reply;
    try {
      if (line.size() > kMaxLineBytes) throw Error(ErrorCode::limit_exceeded, "", "the line is longer than 1 MiB", "");
      reply = answer(line);
    } catch (const Error& error) {
      reply = {{"error", error.what()}, {"line", number}};
      ++failed;
    }
    if (!(out << to_line(reply) << std::flush))
      throw Error(ErrorCode::write_failed, "standard output", "cannot be written", "");
  }
  return failed;
}

}  // namespace uhas
