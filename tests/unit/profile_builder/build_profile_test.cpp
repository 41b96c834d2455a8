#include <doctest/doctest.h>

#include "uhas/profile_builder/build_stages.hpp"

using namespace uhas;

TEST_CASE("fingers are ordered by their first slot; of two that share it, the pinky comes before the ring finger") {
  SphereFrame frame;
  frame.slots = {{false, false, false, false, true},  // thumb
                 {true, true, false, false, false},   // ring
                 {false, false, false, true, false},  // index
                 {true, true, false, false, false}};  // pinky, merged with the ring finger
  frame.own_slot = {4, 1, 3, 0};
  CHECK(fingers_by_slot(frame) == std::vector<int>{3, 1, 2, 0});
}

TEST_CASE("warnings come in the order of the stages") {
  BuildStages stages;
  stages.correspondences.warnings = {"seventh"};
  stages.lateral_tables.warnings = {"fifth", "sixth"};
  stages.closed_pose = {"q_closed", "fingers closed", "fourth", 0.25};
  stages.sphere_frame.warnings = {"third"};
  stages.anatomy.warnings = {"second"};
  stages.model.warnings = {"first"};
  CHECK(stage_warnings(stages) == std::vector<std::string>{"first", "second", "third",
                                                           "doubtful q_closed: fingers closed (fourth); set "
                                                           "\"q_closed\" in a hand config if it is wrong",
                                                           "fifth", "sixth", "seventh"});
}
