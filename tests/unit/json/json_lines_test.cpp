// JSON Lines: what counts as a line, and a conversation that outlives bad ones.
#include "uhas/json/json_lines.hpp"

#include <doctest/doctest.h>

#include <sstream>

#include "support/error_check.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("blank lines are passed over, and counted") {
  std::istringstream in("\n \t\r\n[1]\n\n[2]");
  JsonLines lines(in);
  REQUIRE(lines.next());
  CHECK(lines.document() == Json{1});
  CHECK(lines.number() == 3);
  CHECK(lines.bytes_read() == 9);
  REQUIRE(lines.next());
  CHECK(lines.document() == Json{2});
  CHECK(lines.number() == 5);
  CHECK(lines.bytes_read() == in.str().size());
  CHECK_FALSE(lines.next());
}

TEST_CASE("a line over 1 MiB is refused, blank or not, and the next one read") {
  const std::string blanks(1u << 20, ' ');
  for (const std::string& line : {blanks + " ", blanks + "1"}) {
    std::istringstream in(line + "\n[2]\n");
    JsonLines lines(in);
    REQUIRE(lines.next());
    check_error(ErrorCode::limit_exceeded, "longer than 1 MiB", [&] { lines.document(); });
    REQUIRE(lines.next());
    CHECK(lines.document() == Json{2});
  }
}

TEST_CASE("a bad line is answered by its number, and the conversation goes on") {
  std::istringstream in("1\n\n{\n-1\n3\n");
  std::ostringstream out;
  const auto twice = [](const Json& value) -> Json {
    if (value < 0) throw Error(ErrorCode::invalid_action, "", "below zero", "");
    return 2 * value.get<int>();
  };
  CHECK(answer_json_lines(in, out, twice) == 2);
  std::istringstream answers(out.str());
  JsonLines lines(answers);
  std::vector<Json> documents;
  while (lines.next()) documents.push_back(lines.document());
  REQUIRE(documents.size() == 4);
  CHECK(documents[0] == 2);
  CHECK(documents[1]["line"] == 3);
  CHECK(documents[2] == Json{{"error", "below zero"}, {"line", 4}});
  CHECK(documents[3] == 6);
}

TEST_CASE("an output that takes no more ends the conversation") {
  std::istringstream in("1\n");
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  check_error(ErrorCode::write_failed, "cannot be written",
              [&] { answer_json_lines(in, out, [](const Json& value) { return value; }); });
}
