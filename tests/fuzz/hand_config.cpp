// The text of a hand config: a config or an Error, and a config decides about a small hand.
#include "small_build.hpp"
#include "support/toy_hand.hpp"

using namespace uhas;
using namespace uhas::test;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const HandModel hand = make_toy_hand({.fingers = 2, .wrist = true});
  HandConfig config;
  if (accepted([&] { config = parse_hand_config(std::string(as_text(data, size)), "hand.json"); })) {
    parse_hand_config(to_canonical_json(config), "hand.json");  // what a profile stores can be read again
    build_small(hand, config);
  }
  return 0;
}
