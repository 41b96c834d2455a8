// The same on hands that nobody has tried: random ones. UHAS_SEEDS and UHAS_FIRST_SEED choose others.
#include "opened_limits.hpp"
#include "support/environment.hpp"
#include "support/random_hand.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("sideways ranges of random hands do not depend on limits that the wrap does not reach") {
  const std::uint64_t count = number_from_environment("UHAS_SEEDS", 50);
  const std::uint64_t first = number_from_environment("UHAS_FIRST_SEED", 0);
  int opened = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const BuildStages hand = run_stages(make_random_hand(seed).model, {}, BuildStage::lateral_tables);
    opened += check_opened_limits(hand, LateralTableOptions{}.steps, "seed " + std::to_string(seed));
  }
  CHECK(opened > 0);
}
