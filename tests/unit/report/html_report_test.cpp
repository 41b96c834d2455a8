// The document of a page, taken out of it again, against the small hand's own numbers and against what follows from
// them by hand.
#include "uhas/report/html_report.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "support/error_check.hpp"
#include "support/small_profile.hpp"
#include "uhas/profile_io/flat_profile.hpp"
#include "uhas/report/html/base64.hpp"

using namespace uhas;
using namespace uhas::test;
using doctest::Approx;
using Json = nlohmann::json;

namespace {

ReportHand small_hand() {
  return {.profile = small_profile(),
          .geometry = {},
          .summary_json = R"({"hand": "small hand"})",
          .evaluation_json = "",
          .timeline = {}};
}

Json document_of(const std::string& page) {
  const std::string opening = R"(<script type="application/json" id="uhas-report">)";
  const std::size_t first = page.find(opening);
  REQUIRE(first != std::string::npos);
  const std::size_t begin = first + opening.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

Json hand_document(const ReportHand& hand) { return document_of(html_report("title", {hand})).at("hands").at(0); }

std::vector<std::byte> bytes_of(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  unsigned group = 0, bits = 0;
  for (const char c : base64.substr(0, base64.find('='))) {
    group = (group << 6 | static_cast<unsigned>(digits.find(c))) & 0xffffff;
    bits += 6;
    if (bits >= 8) bits -= 8, bytes.push_back(static_cast<std::byte>(group >> bits & 0xff));
  }
  return bytes;
}

template <class Number>
std::vector<Number> numbers_of(const Json& base64) {
  const std::vector<std::byte> bytes = bytes_of(base64);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

std::size_t count(const std::string& text, const std::string& words) {
  std::size_t found = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("base64 is that of RFC 4648") {
  const auto encoded = [](const std::string& text) { return base64(std::as_bytes(std::span(text))); };
  CHECK(encoded("") == "");
  CHECK(encoded("f") == "Zg==");
  CHECK(encoded("fo") == "Zm8=");
  CHECK(encoded("foo") == "Zm9v");
  CHECK(encoded("foob") == "Zm9vYg==");
  CHECK(encoded("foobar") == "Zm9vYmFy");
  CHECK(base64_of_numbers(std::vector<float>{1}) == "AACAPw==");
}

TEST_CASE("a page names no other file and holds the licence of what it is drawn with") {
  const std::string page = html_report("title", {small_hand()});
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(count(page, "<script src") == 0);
  CHECK(count(page, "rel=\"stylesheet\"") == 0);
  CHECK(count(page, "class UhasRuntime") == 1);
  CHECK(count(page, "three.js authors") == 1);
  const std::vector<std::byte> module = bytes_of(document_of(page).at("wasm"));
  CHECK(module.size() < 300'000);
  CHECK(std::memcmp(module.data(), "\0asm", 4) == 0);
}

TEST_CASE("the same hands give the same page") {
  CHECK(html_report("title", {small_hand(), small_hand()}) == html_report("title", {small_hand(), small_hand()}));
}

TEST_CASE("names cannot end the document or begin a tag") {
  ReportHand hand = small_hand();
  hand.profile.links[0].name = "<!--</script><script>alert(1)";
  const std::string title = "</SCRIPT><b>";
  const std::string page = html_report(title, {hand});
  CHECK(count(page, "</script") == count(html_report("", {small_hand()}), "</script"));
  CHECK(document_of(page).at("title") == title);
  CHECK(document_of(page).at("hands").at(0).at("links").at(0).at("name") == hand.profile.links[0].name);
}

TEST_CASE("the image is the profile with the solver's points and without its history") {
  const Json document = hand_document(small_hand());
  HandProfile expected = small_profile();
  expected.correspondences.erase(expected.correspondences.begin(),
                                 expected.correspondences.begin() + 2);  // the palm's have no weight
  expected.findings.clear();
  expected.warnings.clear();
  expected.sources.clear();
  expected.settings_json.clear();
  CHECK(unflatten_profile(bytes_of(document.at("image"))) == expected);
}

TEST_CASE("slots have the plane and the bounds of the finger that owns them") {
  const Json document = hand_document(small_hand());
  const LateralTable table = small_lateral_table();
  for (int slot = 0; slot < 4; ++slot) {
    CHECK(document.at("planes").at(slot) == table.theta_initial);
    CHECK(document.at("delta_theta_bounds").at(slot) == Json{table.delta_theta_lower, table.delta_theta_upper});
  }
  CHECK(document.at("planes").at(4) == -2);
  CHECK(document.at("delta_theta_bounds").at(4) == Json{0, 0});
  CHECK(document.at("tables").at(0).at("joint") == "index_side");
  CHECK(document.at("tables").at(0).at("finger") == "index");
  CHECK(document.at("tables").at(0).at("driving") == true);
  CHECK(document.at("driving_vectors_phi").at(1).get<double>() == Approx(2.0943951));
}

TEST_CASE("a joint's axis stands in the frame of a link that it carries") {
  const Json joints = hand_document(small_hand()).at("joints");
  // index_1 stands on index_side turned by 0.2 about y and shifted by 1 mm along x
  CHECK(joints.at(0).at("link") == 1);
  CHECK(joints.at(0).at("axis").at(0).get<double>() == Approx(-std::sin(0.2)));
  CHECK(joints.at(0).at("axis").at(2).get<double>() == Approx(std::cos(0.2)));
  CHECK(joints.at(0).at("origin").at(0).get<double>() == Approx(-0.001 * std::cos(0.2)));
  CHECK(joints.at(0).at("origin").at(2).get<double>() == Approx(-0.001 * std::sin(0.2)));
  CHECK(joints.at(1).at("axis") == Json{0, 1, 0});
  CHECK(joints.at(4).at("kind") == "prismatic");

  ReportHand hand = small_hand();
  hand.profile.links[5].joint = hand.profile.links[4].joint;
  hand.profile.fingers[1].joints = {3};
  check_error(ErrorCode::invalid_profile, "joint thumb_slide carries no link", [&] { html_report("", {hand}); });
}

TEST_CASE("points are all there, or an even choice of 6000") {
  ReportHand hand = small_hand();
  const Json few = hand_document(hand).at("points");
  CHECK(numbers_of<std::int32_t>(few.at("link")).size() == 12);
  CHECK(numbers_of<float>(few.at("position"))[3 * 5 + 1] ==
        static_cast<float>(hand.profile.correspondences[5].p_link.y));
  CHECK(numbers_of<float>(few.at("phi"))[7] == static_cast<float>(hand.profile.correspondences[7].phi));

  std::vector<Correspondence> many;
  for (const Correspondence& point : hand.profile.correspondences) many.insert(many.end(), 1000, point);
  hand.profile.correspondences = many;
  const std::vector<std::int32_t> links = numbers_of<std::int32_t>(hand_document(hand).at("points").at("link"));
  CHECK(links.size() == 6000);
  for (std::int32_t link = 0; link < 6; ++link) CHECK(std::ranges::count(links, link) == 1000);
}

TEST_CASE("meshes keep their links, and are simplified when they are too fine") {
  ReportHand hand = small_hand();
  hand.geometry.links.resize(6);
  hand.geometry.links[2] = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}};
  constexpr std::uint32_t n = 180;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      hand.geometry.links[4].vertices.push_back({0.01 * i, 0.01 * j, 0});
      if (i > 0 && j > 0) {
        const std::uint32_t k = i * n + j;
        hand.geometry.links[4].triangles.insert(hand.geometry.links[4].triangles.end(),
                                                {{k, k - 1, k - n}, {k - 1, k - n - 1, k - n}});
      }
    }
  REQUIRE(triangle_count(hand.geometry) > 60'000);
  const Json meshes = hand_document(hand).at("meshes");
  REQUIRE(meshes.size() == 2);
  CHECK(meshes.at(0).at("link") == 2);
  CHECK(numbers_of<float>(meshes.at(0).at("vertices")).size() == 9);
  CHECK(numbers_of<std::uint32_t>(meshes.at(0).at("triangles")).size() == 3);
  CHECK(meshes.at(1).at("link") == 4);
  CHECK(numbers_of<std::uint32_t>(meshes.at(1).at("triangles")).size() <= 3 * 40'000);
}

TEST_CASE("a timeline has the actions in radians and radii, and what the solver answers") {
  ReportHand hand = small_hand();
  const LateralTable table = small_lateral_table();
  std::vector<double> action(10, 0.0);  // one driving vector
  action[1] = -0.5, action[4] = 1, action[8] = -1, action[9] = 0.25;
  hand.timeline = {.actions = {action},
                   .driving_vectors_phi = {1.2},
                   .normalized = true,
                   .options = {.closing = CascadeClosing::hard, .passes = 2}};
  const Json document = hand_document(hand), timeline = document.at("timeline");
  const std::vector<double> expected{0, 0.5 * table.delta_theta_lower, 0, 0, 0, 0, 0, 0, -2, 0.5};
  CHECK(timeline.at("actions").at(0) == Json(expected));
  CHECK(document.at("driving_vectors_phi") == Json{1.2});
  CHECK(timeline.at("options") == Json{{"rule", "correspondence"},
                                       {"closing", "hard"},
                                       {"field", "finger"},
                                       {"passes", 2},
                                       {"driving_vectors_phi", {1.2}}});

  CascadeSolver<double> solver(hand.profile, hand.timeline->options);
  std::vector<double> q(5);
  REQUIRE(solver.solve({.values = expected, .driving_vectors_phi = hand.timeline->driving_vectors_phi}, q) ==
          Status::ok);
  CHECK(timeline.at("q").at(0) == Json(q));

  hand.timeline->driving_vectors_phi = {4};
  check_error(ErrorCode::invalid_action, "action 0: driving-vector angles must increase",
              [&] { html_report("", {hand}); });
  hand.timeline->actions.clear();
  CHECK(hand_document(hand).at("timeline").is_null());
}
