// Design, section 4, properties 1 to 5: a hand that is scaled, moved, mirrored, or described with other axis signs,
// other names or in another order is the same hand, from the anatomy to the solutions.
#include <doctest/doctest.h>
#include <tinyxml.h>

#include "same_hand.hpp"
#include "support/model_transforms.hpp"
#include "support/real_profile.hpp"
#include "support/scratch_folder.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

const HandModel& model() { return real_stages().model; }

void check(HandModel changed, const Relation& relation, const std::string& what) {
  const HandProfile profile = make_profile(run_stages(std::move(changed), {}, BuildStage::correspondences), {});
  check_same_hand(real_profile(), profile, relation, what);
}

/// Shuffles the elements inside `parent`, and those inside them.
void shuffle_elements(TiXmlElement& parent, std::mt19937_64& random) {
  std::vector<std::unique_ptr<TiXmlNode>> elements;
  while (TiXmlElement* element = parent.FirstChildElement()) {
    shuffle_elements(*element, random);
    elements.emplace_back(element->Clone());
    parent.RemoveChild(element);
  }
  std::shuffle(elements.begin(), elements.end(), random);
  for (const auto& element : elements) parent.InsertEndChild(*element);
}

/// Fills `copy` with folders and links like those of `folder`.
void link_folder(const std::filesystem::path& folder, const std::filesystem::path& copy) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path target = copy / relative(entry.path(), folder);
    if (entry.is_directory())
      create_directories(target);
    else
      create_symlink(entry.path(), target);
  }
}

}  // namespace

TEST_CASE("scale") {
  for (const double scale : {0.001, 0.37, 3.0, 1000.0})
    check(scaled(model(), scale), {.scale = scale}, "scaled by " + std::to_string(scale));
}

TEST_CASE("root frame") {
  for (const unsigned seed : {1, 2, 3}) {
    std::mt19937_64 random(seed);
    check(with_moved_root(model(), random_pose(random)), {}, "root moved, seed " + std::to_string(seed));
  }
}

TEST_CASE("axis signs") {
  for (const unsigned seed : {1, 2, 3}) {
    std::mt19937_64 random(seed);
    std::vector<bool> flipped;
    Relation relation;
    for (const Joint& joint : model().tree.joints) {
      flipped.push_back(random() % 2 == 0);
      if (flipped.back()) relation.flipped.insert(joint.name);
    }
    check(with_flipped_axes(model(), flipped), relation, "axes flipped, seed " + std::to_string(seed));
  }
}

TEST_CASE("order of elements in the URDF") {
  const std::filesystem::path folder = std::filesystem::absolute(real_hand().folder);
  ModelLoadOptions options;
  options.allow_outside = true;  // where the links lead
  for (const unsigned seed : {1, 2, 3}) {
    std::mt19937_64 random(seed);
    const ScratchFolder scratch;
    link_folder(folder, scratch.path());
    TiXmlDocument document;
    REQUIRE(document.LoadFile(real_hand().urdf.string().c_str()));
    shuffle_elements(*document.RootElement(), random);
    const std::filesystem::path urdf = scratch.path() / relative(real_hand().urdf, real_hand().folder);
    std::filesystem::remove(urdf);
    REQUIRE(document.SaveFile(urdf.string().c_str()));
    check(load_hand_model(urdf.string(), options), {}, "elements shuffled, seed " + std::to_string(seed));
  }
}

TEST_CASE("names") { check(with_reversed_siblings(model()), {}, "siblings renamed"); }

TEST_CASE("mirror") { check(mirrored(model()), {.mirrored = true}, "mirrored"); }
