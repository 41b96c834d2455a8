// Rebuilding a hand from the settings its profile stores gives the same profile, byte for byte; so does a hand config
// that states all that was inferred, but for the words that say where it comes from.
#include <doctest/doctest.h>

#include "support/real_profile.hpp"
#include "support/rebuild_from_config.hpp"
#include "support/scratch_folder.hpp"
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
  test::check_rebuild_from_config(test::real_hand().urdf.string());
}
