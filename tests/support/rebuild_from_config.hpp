// Stating all that was inferred changes nothing.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "uhas/profile_builder/complete_config.hpp"

namespace uhas::test {

/// Builds the profile of a URDF, writes what was inferred as a hand config, builds with that, and checks that the two
/// profiles are equal in every number and name: joints, poses, frames, classes, fingers, tables and surface points, bit
/// for bit. Only what tells where they come from may differ: findings, warnings and settings.
inline void check_rebuild_from_config(const std::string& urdf) {
  BuildSettings settings;
  const BuildStages stages = run_stages(urdf, settings, Stage::correspondences);
  const HandProfile inferred = make_profile(stages, settings);

  settings.config = parse_hand_config(to_canonical_json(complete_config(stages, settings)), "hand.json");
  HandProfile stated = build_profile(urdf, settings);
  for (const Finding& finding : stated.findings) {
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

}  // namespace uhas::test
