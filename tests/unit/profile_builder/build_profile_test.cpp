#include "uhas/profile_builder/build_profile.hpp"

#include <doctest/doctest.h>

using namespace uhas;

TEST_CASE("fingers are ordered by their first slot; the order of equals stays") {
  SphereFrame frame;
  frame.slots = {{false, false, false, false, true},  // thumb
                 {true, true, false, false, false},   // ring
                 {false, false, false, true, false},  // index
                 {true, true, false, false, false}};  // pinky, merged with the ring finger
  CHECK(fingers_by_slot(frame) == std::vector<int>{1, 3, 2, 0});
}

TEST_CASE("warnings come in the order of the stages") {
  BuildStages stages;
  stages.correspondences.warnings = {"sixth"};
  stages.lateral_tables.warnings = {"fourth", "fifth"};
  stages.closed_pose = {"q_closed", "fingers closed", "third", 0.25};
  stages.anatomy.warnings = {"second"};
  stages.model.warnings = {"first"};
  CHECK(stage_warnings(stages) == std::vector<std::string>{"first", "second",
                                                           "doubtful q_closed: fingers closed (third); set "
                                                           "\"q_closed\" in a hand config if it is wrong",
                                                           "fourth", "fifth", "sixth"});
}
