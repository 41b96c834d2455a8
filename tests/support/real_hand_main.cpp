// `main` of the tests on real hands: skips by name when UHAS_HANDS_DIR is not set, fails when it is set but wrong.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "support/real_hand.hpp"

namespace uhas::test {
namespace {

RealHand load_real_hand() {
  RealHand hand;
  hand.name = std::getenv("UHAS_HAND");
  hand.folder = std::filesystem::path(std::getenv("UHAS_HANDS_DIR")) / hand.name;
  // a hand of the project's own: no truth.json, and the URDF is named like the folder
  hand.urdf = hand.folder / (hand.name + ".urdf");
  if (exists(hand.urdf)) return hand;
  std::ifstream file(hand.folder / "truth.json");
  if (!file)
    throw std::runtime_error("UHAS_HANDS_DIR is set, but " + (hand.folder / "truth.json").string() + " cannot be read");
  hand.truth = nlohmann::json::parse(file);
  hand.urdf = hand.folder / hand.truth.at("urdf").get<std::string>();
  return hand;
}

}  // namespace

const RealHand& real_hand() {
  static const RealHand hand = load_real_hand();
  return hand;
}

}  // namespace uhas::test

int main(int argc, char** argv) {
  constexpr int skipped = 77;  // ctest's SKIP_RETURN_CODE of these tests
  if (!std::getenv("UHAS_HAND")) {
    std::cerr << "set UHAS_HAND to the name of a folder in UHAS_HANDS_DIR\n";
    return 2;
  }
  if (!std::getenv("UHAS_HANDS_DIR")) {
    std::cout << "SKIPPED: UHAS_HANDS_DIR is not set\n";
    return skipped;
  }
  try {
    uhas::test::real_hand();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return doctest::Context(argc, argv).run();
}
