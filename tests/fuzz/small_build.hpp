// A build of few samples, to its end: what the loader or a hand config let through must not break a later stage.
#pragma once

#include "fuzz_file.hpp"
#include "uhas/profile_builder/build_stages.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas::test {

/// Builds the profile of `model` and solves the zero action. A hand may be refused; a built profile must solve.
inline void build_small(HandModel model, const HandConfig& config) {
  BuildSettings settings;
  settings.config = config;
  settings.lateral_tables.steps = 21;
  settings.correspondences.samples = 200;
  HandProfile profile;
  if (!accepted([&] {
        profile = make_profile(run_stages(std::move(model), settings, BuildStage::correspondences), settings);
      }))
    return;
  CascadeSolver<double> solver(profile);
  const std::vector<double> action(15);
  std::vector<double> q(profile.tree.joints.size());
  require(solver.solve({.values = action}, q) == Status::ok);
}

}  // namespace uhas::test
