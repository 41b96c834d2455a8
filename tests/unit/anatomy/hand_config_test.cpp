#include "uhas/anatomy/hand_config.hpp"

#include <doctest/doctest.h>

#include "support/scratch_folder.hpp"
#include "uhas/base/errors.hpp"

using namespace uhas;
using uhas::test::ScratchFolder;

namespace {

HandConfig read(const std::string& text) {
  const ScratchFolder folder;
  return read_hand_config(folder.write("hand.json", text));
}

struct Refusal {
  ErrorCode code{};
  std::string message;
};

Refusal refusal(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("an empty config leaves everything to be inferred") {
  const HandConfig config = read("{}");
  CHECK(!config.palm_link);
  CHECK(!config.palm_normal_in_root);
  CHECK(!config.handedness);
  CHECK(config.q_open.empty());
  CHECK(config.q_closed.empty());
  CHECK(to_canonical_json(config) == "{}");
  CHECK(!read(R"({"palm_link": "", "handedness": ""})").palm_link);
}

TEST_CASE("every key is read") {
  const HandConfig config = read(R"({
    "format": "uhas-hand-config", "version": 1, "comment": "why",
    "palm_link": "palm", "palm_normal_in_root": [0, 0, 2], "handedness": "left",
    "q_open": {"b": 0.5, "a": -1}, "q_closed": {"a": 1.5}})");
  CHECK(config.palm_link == "palm");
  CHECK(config.palm_normal_in_root == Vector3d{0, 0, 2});
  CHECK(config.handedness == Handedness::left);
  CHECK(config.q_open == std::map<std::string, double>{{"a", -1}, {"b", 0.5}});
  CHECK(config.q_closed == std::map<std::string, double>{{"a", 1.5}});
  CHECK(to_canonical_json(config) ==
        R"({"handedness":"left","palm_link":"palm","palm_normal_in_root":[0.0,0.0,2.0],"q_closed":{"a":1.5},)"
        R"("q_open":{"a":-1.0,"b":0.5}})");
}

TEST_CASE("an unknown key names the nearest known one") {
  const Refusal refused = refusal(R"({"palm_lnk": "palm"})");
  CHECK(refused.code == ErrorCode::invalid_config);
  CHECK(contains(refused.message, "unknown key \"palm_lnk\"; did you mean \"palm_link\"?"));
}

TEST_CASE("unusable values are refused by name") {
  CHECK(contains(refusal(R"({"palm_link": 3})").message, "\"palm_link\" is not a string"));
  CHECK(contains(refusal(R"({"handedness": "both"})").message, "\"handedness\" is \"both\""));
  CHECK(contains(refusal(R"({"palm_normal_in_root": [0, 0]})").message, "three numbers"));
  CHECK(contains(refusal(R"({"palm_normal_in_root": [0, 0, 0]})").message, "no direction"));
  CHECK(contains(refusal(R"({"q_open": {"j": "wide"}})").message, "joint \"j\" has no finite number"));
  CHECK(contains(refusal(R"({"q_closed": [1]})").message, "\"q_closed\" is not an object"));
  CHECK(refusal(R"([])").code == ErrorCode::invalid_config);
  CHECK(refusal(R"({"format": "uhas-actions"})").code == ErrorCode::invalid_config);
  CHECK(refusal(R"({"version": 2})").code == ErrorCode::unsupported_version);
}

TEST_CASE("a file that is no JSON names the line, a missing file its path") {
  const Refusal refused = refusal("{\n\"palm_link\": \"palm\"\n\"handedness\": \"left\"}");
  CHECK(refused.code == ErrorCode::syntax);
  CHECK(contains(refused.message, "hand.json:3: not valid JSON"));
  CHECK_THROWS_WITH_AS(read_hand_config("/nowhere/hand.json"), doctest::Contains("/nowhere/hand.json: cannot be read"),
                       Error);
}
