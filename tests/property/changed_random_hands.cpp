// Design, section 4, properties 1 to 5, up to the lateral tables, on hands that nobody has tried: random ones, each
// described anew in all ways at once. UHAS_SEEDS and UHAS_FIRST_SEED choose others.
#include <doctest/doctest.h>

#include "same_hand.hpp"
#include "support/environment.hpp"
#include "support/model_transforms.hpp"
#include "support/random_hand.hpp"
#include "uhas/profile_builder/build_stages.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

HandProfile profile_of(const HandModel& model) {
  return make_profile(run_stages(model, {}, BuildStage::correspondences), {});
}

}  // namespace

TEST_CASE("random hands described anew") {
  const std::uint64_t count = number_from_environment("UHAS_SEEDS", 50);
  const std::uint64_t first = number_from_environment("UHAS_FIRST_SEED", 0);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const RandomHand hand = make_random_hand(seed);
    const HandModel& model = hand.model;
    if (!hand.has_surface) continue;
    std::mt19937_64 random(seed);
    Relation relation{.scale = std::exp(std::uniform_real_distribution<double>(-2, 2)(random)),
                      .mirrored = seed % 2 == 1};
    std::vector<bool> flipped;
    for (const Joint& joint : model.tree.joints) {
      flipped.push_back(random() % 2 == 0);
      if (flipped.back()) relation.flipped.insert(joint.name);
    }
    HandModel changed = with_moved_root(scaled(with_flipped_axes(model, flipped), relation.scale), random_pose(random));
    if (relation.mirrored) changed = mirrored(std::move(changed));
    // which of a gripper's like fingers comes first, names alone can tell
    if (hand.has_thumb.value_or(false)) changed = with_reversed_siblings(changed);
    // Phalanges with edges: a single ray that flips moves a stored point to another face, and solutions with it.
    check_same_hand(profile_of(model), profile_of(changed), relation, "seed " + std::to_string(seed), Extent::tables);
  }
}
