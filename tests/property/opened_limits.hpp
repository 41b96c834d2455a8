// Sideways ranges belong to the wrapped pose, not to the fully flexed one that limits decide
// (docs/method.md#lateral-tables).
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::test {

/// Whether joint `j` closes toward its upper limit.
inline bool closes_upward(const BuildStages& hand, int j) {
  const Joint& joint = hand.anatomy.tree.joints[j];
  return joint.upper - hand.q_closed[j] <= hand.q_closed[j] - joint.lower;
}

/// [joint] whether wrapping the hand, wherever a table's joint stands, brings the joint to its closed limit.
inline std::vector<bool> joints_held_at_closed(const BuildStages& hand) {
  const std::vector<Joint>& joints = hand.anatomy.tree.joints;
  SphereWrapper wrapper(hand.anatomy, hand.sphere_frame, hand.joint_classes, hand.q_closed);
  std::vector<bool> held(joints.size(), false);
  for (const LateralTable& table : hand.lateral_tables.tables) {
    const Joint& swept = joints[table.joint];
    constexpr int samples = 401;  // of the whole range: the stretch was chosen from it
    for (int k = 0; k < samples; ++k) {
      std::vector<double> q = hand.lateral_tables.q_sphere;
      q[table.joint] = swept.lower + (swept.upper - swept.lower) * k / (samples - 1);
      apply_mimics(hand.anatomy.tree, q);
      wrapper.wrap(q);
      for (std::size_t j = 0; j < joints.size(); ++j) held[j] = held[j] || std::abs(q[j] - hand.q_closed[j]) < 1e-6;
    }
  }
  return held;
}

/// Opens the closed limit of every joint that the wrap never takes there, far beyond, and expects the same tables.
/// Returns how many joints that were.
inline int check_opened_limits(const BuildStages& hand, int steps, const std::string& label) {
  constexpr double opened_by = 0.5;
  const std::vector<bool> held = joints_held_at_closed(hand);
  BuildStages opened = hand;
  int count = 0;
  for (int j = 0; j < static_cast<int>(held.size()); ++j) {
    Joint& joint = opened.anatomy.tree.joints[j];
    const bool free = hand.joint_classes[j].joint_class == JointClass::encompassing && joint.mimic_master < 0 &&
                      joint.kind == JointKind::revolute;
    const bool followed =
        std::ranges::any_of(hand.anatomy.tree.joints, [&](const Joint& other) { return other.mimic_master == j; });
    if (!free || followed || held[j]) continue;
    (closes_upward(hand, j) ? joint.upper : joint.lower) += closes_upward(hand, j) ? opened_by : -opened_by;
    opened.q_closed[j] = closes_upward(hand, j) ? joint.upper : joint.lower;
    ++count;
  }
  const LateralTables tables = build_lateral_tables(opened.anatomy, opened.sphere_frame, opened.joint_classes,
                                                    opened.q_closed, {.steps = steps});
  CAPTURE(label);
  REQUIRE(tables.tables.size() == hand.lateral_tables.tables.size());
  for (std::size_t t = 0; t < tables.tables.size(); ++t) {
    const LateralTable &before = hand.lateral_tables.tables[t], &after = tables.tables[t];
    CAPTURE(hand.anatomy.tree.joints[before.joint].name);
    CHECK(after.joint == before.joint);
    CHECK(after.delta_theta_lower == doctest::Approx(before.delta_theta_lower).epsilon(1e-9));
    CHECK(after.delta_theta_upper == doctest::Approx(before.delta_theta_upper).epsilon(1e-9));
  }
  return count;
}

}  // namespace uhas::test
