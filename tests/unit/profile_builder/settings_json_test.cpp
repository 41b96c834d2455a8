#include "uhas/profile_builder/settings_json.hpp"

#include <doctest/doctest.h>

#include "uhas/base/errors.hpp"

using namespace uhas;

TEST_CASE("the default settings as canonical JSON") {
  CHECK(to_canonical_json(BuildSettings{}) ==
        R"({"config":{},"geometry":"visual","lateral_steps":201,"max_radius_deviation":0.5,"merge_pinky":false,)"
        R"("points_per_link":32,"radius_scale":1.0,"samples":20000})");
}

TEST_CASE("settings survive the way through JSON") {
  BuildSettings settings;
  settings.load.geometry = GeometrySource::both;
  settings.config.palm_link = "palm";
  settings.config.palm_normal_in_root = Vector3d{0.1, -0.2, 0.3};
  settings.config.handedness = Handedness::left;
  settings.config.fingers = {{"index"}, {"thumb"}};
  settings.config.fingertips = {{.link = "tip", .point = Vector3d{0, 0, 0.1}, .pad_normal = {}}};
  settings.config.thumb = "thumb";
  settings.config.middle_finger = "";
  settings.config.joint_limits["index"] = {-0.1, 2.0 / 3};
  settings.config.q_open["index"] = 1.0 / 3;
  settings.sphere_frame = {.radius_scale = 1.1, .merge_pinky = true};
  settings.lateral_tables.steps = 51;
  settings.correspondences = {.samples = 1234, .max_radius_deviation = 0.4, .points_per_link = 7};

  const std::string text = to_canonical_json(settings);
  const BuildSettings read = settings_from_json(text, "hand.h5");
  CHECK(to_canonical_json(read) == text);
  CHECK(read.load.geometry == GeometrySource::both);
  CHECK(read.config.q_open.at("index") == 1.0 / 3);
  CHECK(read.sphere_frame.radius_scale == 1.1);
  CHECK(read.correspondences.points_per_link == 7);
}

TEST_CASE("the folders of a machine are not stored") {
  BuildSettings settings;
  settings.load.packages.push_back({"hand_description", "/home/someone/hands"});
  CHECK(to_canonical_json(settings) == to_canonical_json(BuildSettings{}));
}

TEST_CASE("text of another form is refused by name") {
  for (const char* text : {"", "[]", "{}", R"({"geometry":"visual"})", R"({"config":{},"geometry":1})"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(settings_from_json(text, "hand.h5"),
                         "hand.h5: its build settings cannot be read; rebuild the profile", Error);
  }
}
