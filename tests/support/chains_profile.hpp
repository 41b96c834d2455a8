// Hands whose fingers are chains of turns of their own: those that are walked (docs/method.md#whole-fingers).
#pragma once

#include <utility>

#include "support/small_profile.hpp"

namespace uhas::test {

/// The small hand without its mimic and its slide.
inline HandProfile chains_profile() {
  HandProfile p = small_profile();
  p.tree.joints[2].mimic_master = -1, p.tree.joints[2].mimic_multiplier = 1, p.tree.joints[2].mimic_offset = 0;
  p.tree.joints[4].kind = JointKind::revolute;
  p.tree.joints[4].upper = 1.2;
  p.joint_traits[4].q_sphere = 0.4, p.joint_traits[4].q_closed = 1.2;
  place_on_sphere(p);
  return p;
}

/// The same with the lateral joint second: the first joint sees the points beyond through its turn.
inline HandProfile lateral_second_profile() {
  HandProfile p = chains_profile();
  std::swap(p.tree.joints[0].lower, p.tree.joints[1].lower);
  std::swap(p.tree.joints[0].upper, p.tree.joints[1].upper);
  std::swap(p.joint_traits[0], p.joint_traits[1]);
  p.lateral_tables[0].joint = 1;
  place_on_sphere(p);
  return p;
}

}  // namespace uhas::test
