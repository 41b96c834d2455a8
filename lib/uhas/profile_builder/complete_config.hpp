// What was inferred, as the hand config that states all of it.
#pragma once

#include "uhas/profile_builder/build_stages.hpp"

namespace uhas {

/// A hand config with every key set to what the stages found, ready to be corrected by hand. Building with it gives the
/// same profile: every number has the bits it had, only findings, warnings and settings tell the difference.
/// `joint_limits` are those that the settings' config states. Needs the stages up to BuildStage::classification.
HandConfig complete_config(const BuildStages& stages, const BuildSettings& settings);

}  // namespace uhas
