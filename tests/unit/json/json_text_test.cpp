// JSON in and out: bounds, places of mistakes, and layout.
#include "uhas/json/json_text.hpp"

#include <doctest/doctest.h>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("what is no JSON is refused with its line and the reason") {
  check_error(ErrorCode::syntax, "a.json:2: not JSON: syntax error while parsing value - unexpected ','",
              [] { parse_json("[1,\n2,,]", "a.json"); });
  check_error(ErrorCode::syntax, "write numbers within the range of double", [] { parse_json("[1e999]", "a.json"); });
}

TEST_CASE("levels and keys are bounded") {
  CHECK_NOTHROW(parse_json("[[[[[[[[0]]]]]]]]", ""));
  check_error(ErrorCode::syntax, "a.json: nested more than 8 levels deep",
              [] { parse_json("[[[[[[[[[[0]]]]]]]]]]", "a.json"); });

  const auto object = [](int keys) {
    Json result;
    for (int i = 0; i < keys; ++i) result[std::to_string(i)] = 0;
    return result.dump();
  };
  // each object has its own count
  CHECK_NOTHROW(parse_json("[" + object(10'000) + ", {\"a\": " + object(10'000) + "}]", ""));
  check_error(ErrorCode::syntax, "a.json: an object has more than 10000 keys",
              [&] { parse_json("[" + object(10'001) + "]", "a.json"); });
}

TEST_CASE("a file is read within its bound") {
  const ScratchFolder folder;
  const std::string path = folder.write("a.json", "[1, 2]");
  CHECK(read_json_file(path, 6, "") == Json{1, 2});
  check_error(ErrorCode::limit_exceeded, "more than the bound of 5; split it",
              [&] { read_json_file(path, 5, "split it"); });
}

TEST_CASE("documents keep the order of their keys, but for canonical text") {
  const Json one = parse_json(R"({"b": 1, "a": {"d": 0.5, "c": null}})", "");
  const Json other = parse_json(R"({"a": {"c": null, "d": 0.5}, "b": 1})", "");
  CHECK(to_line(one) == "{\"b\":1,\"a\":{\"d\":0.5,\"c\":null}}\n");
  CHECK(to_canonical_text(one) == R"({"a":{"c":null,"d":0.5},"b":1})");
  CHECK(to_canonical_text(other) == to_canonical_text(one));
}

TEST_CASE("a document is one element a line, what fits in a line in one") {
  Json document = new_document("uhas-test");
  document["p"] = to_json(Vector3d{1, 2.5, 3});
  document["numbers"] = std::vector<int>(60, 7);
  CHECK(
      to_text(document).starts_with("{\n  \"format\": \"uhas-test\",\n  \"version\": 1,\n  \"p\": [1.0, 2.5, 3.0],\n"));
  CHECK(parse_json(to_text(document), "") == document);
}
