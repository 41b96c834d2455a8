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

TEST_CASE("every key is read, and its canonical JSON reads the same") {
  const std::string canonical =
      R"({"fingers":[["a","b"],["c"]],"fingertips":[{"link":"tip","pad_normal":[0.0,1.0,0.0],"point":[0.0,0.0,0.5]},)"
      R"({"link":"other"}],"handedness":"left","joint_limits":{"a":[-1.0,0.5]},"middle_finger":null,)"
      R"("palm_link":"palm","palm_normal_in_root":[0.0,0.0,2.0],"q_closed":{"a":1.5},"q_open":{"a":-1.0,"b":0.5},)"
      R"("thumb":"c"})";
  const HandConfig config = read(R"({
    "format": "uhas-hand-config", "version": 1, "comment": "why",
    "palm_link": "palm", "palm_normal_in_root": [0, 0, 2], "fingers": [["a", "b"], ["c"]],
    "fingertips": [{"link": "tip", "point": [0, 0, 0.5], "pad_normal": [0, 1, 0]}, {"link": "other"}],
    "thumb": "c", "middle_finger": null, "handedness": "left",
    "q_open": {"b": 0.5, "a": -1}, "q_closed": {"a": 1.5}, "joint_limits": {"a": [-1, 0.5]}})");
  CHECK(config.palm_link == "palm");
  CHECK(config.palm_normal_in_root == Vector3d{0, 0, 2});
  CHECK(config.fingers == std::vector<std::vector<std::string>>{{"a", "b"}, {"c"}});
  REQUIRE(config.fingertips.size() == 2);
  CHECK(config.fingertips[0].point == Vector3d{0, 0, 0.5});
  CHECK(config.fingertips[0].pad_normal == Vector3d{0, 1, 0});
  CHECK(!config.fingertips[1].point);
  CHECK(config.thumb == "c");
  CHECK(config.middle_finger == "");
  CHECK(config.handedness == Handedness::left);
  CHECK(config.q_open == std::map<std::string, double>{{"a", -1}, {"b", 0.5}});
  CHECK(config.q_closed == std::map<std::string, double>{{"a", 1.5}});
  CHECK(config.joint_limits.at("a").lower == -1);
  CHECK(config.joint_limits.at("a").upper == 0.5);
  CHECK(to_canonical_json(config) == canonical);
  CHECK(to_canonical_json(parse_hand_config(canonical, "hand.json")) == canonical);
  for (const char* handedness : {"right", "none"}) {
    const std::string text = std::string(R"({"handedness":")") + handedness + "\"}";
    CHECK(to_canonical_json(read(text)) == text);
  }
}

TEST_CASE("an unknown key names the nearest known one") {
  const Refusal refused = refusal(R"({"palm_lnk": "palm"})");
  CHECK(refused.code == ErrorCode::invalid_config);
  CHECK(contains(refused.message, "unknown key \"palm_lnk\"; did you mean \"palm_link\"?"));
  CHECK(contains(refusal(R"({"palm": "palm"})").message, "did you mean \"palm_link\"?"));
  CHECK(contains(refusal(R"({"fingertips": [{"lnk": "tip"}]})").message,
                 "\"fingertips\": unknown key \"lnk\"; did you mean \"link\"?"));
}

TEST_CASE("unusable values are refused by name") {
  CHECK(contains(refusal(R"({"palm_link": 3})").message, "\"palm_link\" is not a string"));
  CHECK(contains(refusal(R"({"handedness": "both"})").message, "\"handedness\" is \"both\""));
  CHECK(contains(refusal(R"({"palm_normal_in_root": [0, 0]})").message, "three numbers"));
  CHECK(contains(refusal(R"({"palm_normal_in_root": [0, 0, 0]})").message, "no direction"));
  CHECK(contains(refusal(R"({"q_open": {"j": "wide"}})").message, "joint \"j\" has no finite number"));
  CHECK(contains(refusal(R"({"q_closed": [1]})").message, "\"q_closed\" is not an object"));
  CHECK(contains(refusal(R"({"fingers": ["a", "b"]})").message, "\"fingers\" is not a list of lists"));
  CHECK(contains(refusal(R"({"fingers": [["a", 3]]})").message, "a joint in \"fingers\" is not a string"));
  CHECK(contains(refusal(R"({"fingertips": ["tip"]})").message, "\"fingertips\" is not a list of objects"));
  CHECK(contains(refusal(R"({"fingertips": [{}]})").message, "an element has no \"link\""));
  CHECK(contains(refusal(R"({"fingertips": [{"link": "tip", "point": 1}]})").message, "three numbers"));
  CHECK(contains(refusal(R"({"thumb": ""})").message, "\"thumb\" names no joint"));
  CHECK(contains(refusal(R"({"middle_finger": 2})").message, "\"middle_finger\" names no joint"));
  CHECK(contains(refusal(R"({"joint_limits": {"j": [1]}})").message, "joint \"j\" has no limits"));
  CHECK(contains(refusal(R"({"joint_limits": {"j": [1, 1]}})").message, "the lower limit is not below the upper"));
  CHECK(contains(refusal(R"({"q_open": {"j": 1e999}})").message, "write numbers within the range of double"));
  CHECK(refusal(R"([])").code == ErrorCode::invalid_config);
  CHECK(refusal(R"({"format": "uhas-actions"})").code == ErrorCode::invalid_config);
  CHECK(refusal(R"({"version": 2})").code == ErrorCode::unsupported_version);
}

TEST_CASE("a file that is no JSON names the line, a missing file its path") {
  const Refusal refused = refusal("{\n\"palm_link\": \"palm\"\n\"handedness\": \"left\"}");
  CHECK(refused.code == ErrorCode::syntax);
  CHECK(contains(refused.message, "hand.json:3: not JSON"));
  CHECK_THROWS_WITH_AS(read_hand_config("/nowhere/hand.json"),
                       doctest::Contains("/nowhere/hand.json: the file does not exist"), Error);
}

TEST_CASE("size and nesting are bounded") {
  CHECK(refusal("{\"comment\": \"" + std::string(1u << 20, 'x') + "\"}").code == ErrorCode::limit_exceeded);
  CHECK(refusal("{\"version\": " + std::string(500'000, '[')).code == ErrorCode::syntax);
}
