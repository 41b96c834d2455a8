// The profile of the real hand of this run, built once.
#pragma once

#include "support/real_hand.hpp"
#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::test {

inline const BuildStages& real_stages() {
  static const BuildStages stages = run_stages(real_hand().urdf.string(), {}, BuildStage::correspondences);
  return stages;
}

inline const HandProfile& real_profile() {
  static const HandProfile profile = make_profile(real_stages(), {});
  return profile;
}

inline int thumb_of(const HandProfile& profile) {
  for (std::size_t f = 0; f < profile.fingers.size(); ++f)
    if (profile.fingers[f].slots[4]) return static_cast<int>(f);
  return -1;
}

}  // namespace uhas::test
