// Random hands that know their own anatomy: nearly all are read right, and hardly a miss goes without a warning.
// UHAS_SEEDS and UHAS_FIRST_SEED choose others; every miss prints its seed.
#include <doctest/doctest.h>

#include <numbers>

#include "support/environment.hpp"
#include "support/random_hand.hpp"
#include "uhas/sphere_frame/sphere_frame.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kNormalTolerance = 15 * std::numbers::pi / 180;

/// For each chain of the truth, the finger that has it; -1 = none.
std::vector<int> match_fingers(const RandomHand& hand, const Anatomy& anatomy) {
  std::vector<int> match(hand.chains.size(), -1);
  for (std::size_t i = 0; i < match.size(); ++i) {
    for (std::size_t j = 0; j < anatomy.fingers.size(); ++j) {
      std::vector<std::string> chain;
      for (int joint : anatomy.fingers[j].joints) chain.push_back(anatomy.tree.joints[joint].name);
      if (chain == hand.chains[i]) match[i] = static_cast<int>(j);
    }
  }
  return match;
}

/// What was found wrong, in words; empty = all right.
std::string misses(const RandomHand& hand, const Anatomy& anatomy) {
  const SphereFrame frame = compute_sphere_frame(anatomy);
  const Vector3d normal = anatomy.T_root_palm.rotation * anatomy.palm_normal_palm;
  std::string text;
  if (dot(normal, hand.normal_root) < std::cos(kNormalTolerance)) text += " normal";
  const std::vector<int> match = match_fingers(hand, anatomy);
  if (anatomy.fingers.size() != match.size() || std::count(match.begin(), match.end(), -1) > 0)
    return text + " fingers";
  if (anatomy.thumb != (hand.has_thumb ? match.back() : -1)) text += " thumb";
  if (anatomy.handedness != hand.handedness) text += " handedness";
  for (std::size_t i = 0; i < match.size(); ++i)
    if (hand.slots[i] >= 0 && !frame.slots[match[i]][hand.slots[i]]) text += " slot" + std::to_string(hand.slots[i]);
  return text;
}

}  // namespace

TEST_CASE("random hands") {
  const std::uint64_t count = number_from_environment("UHAS_SEEDS", 500);
  const std::uint64_t first = number_from_environment("UHAS_FIRST_SEED", 0);
  std::uint64_t missed = 0, silent = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const RandomHand hand = RandomHandMaker(seed).make();
    const Anatomy anatomy = infer_anatomy(hand.model);
    const std::string wrong = misses(hand, anatomy);
    if (wrong.empty()) continue;
    ++missed;
    if (anatomy.warnings.empty()) ++silent;
    MESSAGE("seed ", seed, std::string(anatomy.warnings.empty() ? ", no warning:" : ":"), wrong);
  }
  MESSAGE(missed, " of ", count, " missed, ", silent, " of them without a warning");
  CHECK(missed * 50 <= count);
  CHECK(silent * 50 <= count);
}
