// Rebuilding a hand from the settings its profile stores gives the same profile, byte for byte; so does a hand config
// that states all that was inferred, but for the words that say where it comes from.
#include <doctest/doctest.h>

#include "support/real_profile.hpp"
#include "support/scratch_folder.hpp"
#include "uhas/profile_builder/complete_config.hpp"
#include "uhas/profile_builder/settings_json.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;

TEST_CASE("stored settings rebuild the profile") {
  const test::ScratchFolder folder;
  BuildSettings settings;
  settings.sphere_frame = {.radius_scale = 1.05, .merge_pinky = true};
  settings.lateral_tables.steps = 101;
  settings.correspondences.samples = 5000;
  const std::string urdf = test::real_hand().urdf.string();
  write_profile(build_profile(urdf, settings), folder.file("first.h5"));

  const HandProfile first = read_profile(folder.file("first.h5"));
  write_profile(build_profile(urdf, settings_from_json(first.settings_json, "first.h5")), folder.file("second.h5"));
  CHECK(test::read_bytes(folder.file("first.h5")) == test::read_bytes(folder.file("second.h5")));
}

TEST_CASE("a config of all that was inferred rebuilds the profile") {
  BuildSettings settings;
  const BuildStages& stages = test::real_stages();
  const HandProfile& inferred = test::real_profile();

  settings.config = parse_hand_config(to_canonical_json(complete_config(stages, settings)), "hand.json");
  HandProfile stated = build_profile(test::real_hand().urdf.string(), settings);
  for (const HandFinding& finding : stated.findings) {
    CAPTURE(finding.item);
    CHECK(finding.confidence == 1);
    CHECK(finding.reason == "stated in the hand config");
  }
  stated.findings = inferred.findings;
  stated.warnings = inferred.warnings;
  stated.settings_json = inferred.settings_json;
  CHECK(stated.tree == inferred.tree);
  CHECK(stated.joint_traits == inferred.joint_traits);
  CHECK(stated.T_palm_sphere == inferred.T_palm_sphere);
  CHECK(stated.fingers == inferred.fingers);
  CHECK(stated.lateral_tables == inferred.lateral_tables);
  CHECK(stated.correspondences == inferred.correspondences);
  CHECK(stated == inferred);
}
