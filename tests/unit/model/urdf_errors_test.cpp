// Every URDF that is refused, with the words of its message.
#include <sys/resource.h>

#include "model_fixture.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

const std::string palm_and_finger = link("palm") + link("finger");

std::string with_limit(const std::string& lower, const std::string& upper) {
  return robot(palm_and_finger +
               joint("knuckle", "palm", "finger",
                     "<limit lower=\"" + lower + "\" upper=\"" + upper + R"(" effort="1" velocity="1"/>)"));
}

std::string with_axis(const std::string& axis) {
  return robot(palm_and_finger + "<joint name=\"knuckle\" type=\"continuous\"><axis xyz=\"" + axis +
               "\"/><parent link=\"palm\"/><child link=\"finger\"/></joint>");
}

}  // namespace

TEST_CASE("a missing file") {
  check_error([] { load_hand_model("/no/such/hand.urdf"); }, ErrorCode::file_unreadable,
              {"/no/such/hand.urdf", "does not exist"});
}

TEST_CASE("a folder instead of a file") {
  const ScratchFolder folder;
  check_error([&] { load_hand_model(folder.path()); }, ErrorCode::file_unreadable, {"not a regular file"});
}

TEST_CASE("a xacro file names the command that expands it") {
  check_error([] { load_hand_model("hand.xacro"); }, ErrorCode::syntax, {"xacro hand.xacro > hand.urdf"});
  check_load_error(robot("<xacro:include filename=\"x\"/>" + palm_and_finger), ErrorCode::syntax,
                   {"<xacro:include>", "expand"});
}

TEST_CASE("text that is no URDF") {
  check_load_error("", ErrorCode::syntax, {"not well-formed XML"});
  check_load_error("<!-- nothing -->", ErrorCode::syntax, {"no XML element"});
  check_load_error("a hand", ErrorCode::syntax, {"XML"});
  check_load_error("<robot name=\"x\">\n<link name=\"a\"></robot>", ErrorCode::syntax,
                   {"hand.urdf:", "not well-formed XML"});
  check_load_error("<robot name=\"x\">\n<link name=\"a", ErrorCode::syntax, {"hand.urdf:2", "ends inside"});
  check_load_error("<sdf/>", ErrorCode::syntax, {"not a URDF", "<sdf>"});
  check_load_error(std::string("<robot>\0</robot>", 16), ErrorCode::syntax, {"zero byte"});
  check_load_error("<robot/>", ErrorCode::invalid_model, {"name"});
  check_load_error(robot(""), ErrorCode::invalid_model, {"link"});
}

TEST_CASE("links and joints without a name") {
  check_load_error(robot("\n<link/>"), ErrorCode::invalid_model, {"hand.urdf:2", "a link has no name"});
  check_load_error(robot(palm_and_finger + "<joint type=\"fixed\"/>"), ErrorCode::invalid_model,
                   {"a joint has no name"});
}

TEST_CASE("elements nested two hundred thousand deep") {
  std::string deep;
  for (int i = 0; i < 200'000; ++i) deep += "<a>";
  check_load_error("<robot name=\"x\">" + deep, ErrorCode::limit_exceeded, {"nested more than 100"});
}

TEST_CASE("a tag with a hundred thousand attributes") {
  std::string tag = "<link";
  for (int i = 0; i < 100'000; ++i) tag += " a" + std::to_string(i) + "=\"\"";
  check_load_error(robot(tag + "/>"), ErrorCode::limit_exceeded, {"tag is longer"});
}

TEST_CASE("a file above the bound on its size") {
  ModelLoadOptions options;
  options.max_urdf_bytes = 10;
  check_error([&] { load(one_finger(), options); }, ErrorCode::limit_exceeded,
              {"more than the bound of 10", "raise ModelLoadOptions::max_urdf_bytes"});
}

TEST_CASE("more links than any robot has") {
  std::string links = link("l0");
  for (int i = 1; i < 20; ++i)
    links += link("l" + std::to_string(i)) + joint("j" + std::to_string(i), "l0", "l" + std::to_string(i));
  ModelLoadOptions options;
  options.max_links = 19;
  check_error([&] { load(robot(links), options); }, ErrorCode::limit_exceeded,
              {"20 links, more than the bound of 19", "raise ModelLoadOptions::max_links"});
}

TEST_CASE("a long chain of links, for which urdfdom needs more stack than there is") {
  std::string links = link("0");
  for (int i = 1; i < 30'000; ++i) {
    const std::string before = std::to_string(i - 1), name = std::to_string(i);
    links += link(name) + "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + before +
             "\"/><child link=\"" + name + "\"/></joint>";
  }
  rlimit stack{};
  ::getrlimit(RLIMIT_STACK, &stack);
  const rlimit small{512u << 10, stack.rlim_max};
  ::setrlimit(RLIMIT_STACK, &small);
  check_load_error(robot(links), ErrorCode::limit_exceeded, {"30000 links"});
  ModelLoadOptions options;
  options.max_links = 30'000;
  options.in_child.emplace();
  check_error([&] { load(robot(links), options); }, ErrorCode::invalid_model, {"brought down"});
  ::setrlimit(RLIMIT_STACK, &stack);
}

TEST_CASE("no movable joint") {
  check_load_error(robot(link("palm")), ErrorCode::invalid_model, {"no movable joint"});
  check_load_error(robot(palm_and_finger + joint("j", "palm", "finger", "", "fixed")), ErrorCode::invalid_model,
                   {"no movable joint"});
}

TEST_CASE("two links or two joints of one name") {
  check_load_error(robot(link("palm") + link("palm")), ErrorCode::invalid_model, {"two links have the name 'palm'"});
  check_load_error(robot(palm_and_finger + link("b") + joint("j", "palm", "finger") + joint("j", "palm", "b")),
                   ErrorCode::invalid_model, {"two joints have the name 'j'"});
}

TEST_CASE("an unknown parent or child") {
  check_load_error(robot(palm_and_finger + joint("j", "wrist", "finger")), ErrorCode::invalid_model,
                   {"joint 'j' has the unknown parent link 'wrist'"});
  check_load_error(robot(palm_and_finger + joint("j", "palm", "thumb")), ErrorCode::invalid_model,
                   {"joint 'j' has the unknown child link 'thumb'"});
}

TEST_CASE("a link that is its own parent") {
  check_load_error(robot(palm_and_finger + joint("j", "finger", "finger")), ErrorCode::invalid_model,
                   {"joint 'j' has one link as parent and child"});
}

TEST_CASE("a link with two parents") {
  check_load_error(robot(palm_and_finger + link("b") + joint("j", "palm", "finger") + joint("k", "palm", "b") +
                         joint("l", "b", "finger")),
                   ErrorCode::invalid_model, {"link 'finger' has two parents, through joints 'j' and 'l'"});
}

TEST_CASE("several roots") {
  check_load_error(robot(palm_and_finger + link("b") + joint("j", "palm", "finger")), ErrorCode::invalid_model,
                   {"several root links, 'b' and 'palm'", "connect them"});
}

TEST_CASE("a cycle through all links") {
  check_load_error(robot(palm_and_finger + joint("j", "palm", "finger") + joint("k", "finger", "palm")),
                   ErrorCode::invalid_model, {"root"});
}

TEST_CASE("a cycle apart from the root") {
  check_load_error(robot(palm_and_finger + link("a") + link("b") + joint("j", "palm", "finger") + joint("k", "a", "b") +
                         joint("l", "b", "a")),
                   ErrorCode::invalid_model, {"'a' hangs on a cycle"});
}

TEST_CASE("floating and planar joints") {
  for (const char* type : {"floating", "planar"})
    check_load_error(robot(palm_and_finger + joint("free", "palm", "finger", "", type)), ErrorCode::invalid_model,
                     {"joint 'free'", "floating or planar"});
}

TEST_CASE("an unknown joint type") {
  check_load_error(robot(palm_and_finger + joint("odd", "palm", "finger", "", "hinge")), ErrorCode::invalid_model,
                   {"odd", "hinge"});
}

TEST_CASE("a joint without limits") {
  check_load_error(robot(palm_and_finger + joint("knuckle", "palm", "finger", "")), ErrorCode::invalid_model,
                   {"knuckle", "limits"});
  check_load_error(robot(palm_and_finger + joint("slide", "palm", "finger", "", "prismatic")), ErrorCode::invalid_model,
                   {"slide", "limits"});
}

TEST_CASE("limits that are exchanged, not numbers or absurd") {
  check_load_error(with_limit("1", "-1"), ErrorCode::invalid_model,
                   {"joint 'knuckle'", "lower limit above its upper limit"});
  check_load_error(with_limit("-1", "1e16"), ErrorCode::invalid_model,
                   {"joint 'knuckle'", "beyond 1000", "continuous"});
  for (const char* number : {"nan", "inf", "1e999", "one", "", "1,5"})
    check_load_error(with_limit("-1", number), ErrorCode::invalid_model, {"knuckle"});
}

TEST_CASE("an axis without direction") {
  check_load_error(with_axis("0 0 0"), ErrorCode::invalid_model, {"joint 'knuckle'", "axis"});
  check_load_error(with_axis("0 0"), ErrorCode::invalid_model, {"knuckle", "axis"});
  check_load_error(with_axis("nan 0 1"), ErrorCode::invalid_model, {"knuckle", "axis"});
}

TEST_CASE("an origin that is not finite or far away") {
  for (const char* origin : {R"(<origin xyz="1e9 0 0"/>)", R"(<origin xyz="nan 0 0"/>)", R"(<origin rpy="inf 0 0"/>)",
                             R"(<origin xyz="0 0"/>)"})
    check_load_error(robot(palm_and_finger + "<joint name=\"knuckle\" type=\"continuous\">" + origin +
                           R"(<parent link="palm"/><child link="finger"/></joint>)"),
                     ErrorCode::invalid_model, {"knuckle"});
}

TEST_CASE("mimics of nothing, of itself, of a fixed joint and in a cycle") {
  const std::string links = palm_and_finger + link("b") + link("c");
  const std::string rest = joint("k", "palm", "b") + joint("rigid", "palm", "c", "", "fixed");
  const auto with = [&](const std::string& master) {
    return robot(links + joint("j", "palm", "finger", mimic(master)) + rest);
  };
  check_load_error(with("nobody"), ErrorCode::invalid_model, {"joint 'j' mimics 'nobody'", "no joint of the file"});
  check_load_error(with("j"), ErrorCode::invalid_model, {"joint 'j' mimics itself"});
  check_load_error(with("rigid"), ErrorCode::invalid_model, {"joint 'j' mimics the fixed joint 'rigid'"});
  check_load_error(robot(links + joint("j", "palm", "finger", mimic("k")) + joint("k", "palm", "b", mimic("m")) +
                         joint("m", "palm", "c", mimic("k"))),
                   ErrorCode::invalid_model, {"mimics", "cycle"});
}

TEST_CASE("a mimic whose numbers are absurd") {
  check_load_error(robot(palm_and_finger + link("b") + joint("k", "palm", "b") +
                         joint("j", "palm", "finger", mimic("k", "multiplier=\"1e300\""))),
                   ErrorCode::invalid_model, {"joint 'j'", "mimic multiplier"});
}
