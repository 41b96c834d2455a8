// One unknown that moves several joints: a master of joints on several fingers, and one that is a lateral joint.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "support/slider_profile.hpp"
#include "support/small_profile.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;

namespace {

std::vector<double> solve(const HandProfile& profile, const std::vector<double>& action) {
  CascadeSolver<double> solver(profile);
  std::vector<double> q(solver.joint_count());
  REQUIRE(solver.solve({.values = action}, q) == Status::ok);
  return q;
}

std::vector<double> solve_in_lanes(const HandProfile& profile, const std::vector<double>& action, InstructionSet set) {
  BatchSolver<double> solver(profile, {}, {.instruction_set = set});
  const std::size_t rows = 2 * static_cast<std::size_t>(solver.lanes());
  std::vector<double> actions, q(rows * profile.tree.joints.size());
  for (std::size_t row = 0; row < rows; ++row) actions.insert(actions.end(), action.begin(), action.end());
  REQUIRE(solver.solve({.count = rows, .values = actions}, q) == Status::ok);
  return {q.end() - static_cast<std::ptrdiff_t>(profile.tree.joints.size()), q.end()};
}

/// The sliders, the second of which follows the first: q_1 = multiplier q_0.
HandProfile coupled_sliders(double multiplier) {
  HandProfile p = test::slider_profile();
  p.tree.joints[1].mimic_master = 0;
  p.tree.joints[1].mimic_multiplier = multiplier;
  const JointTraits& master = p.joint_traits[0];
  JointTraits& follower = p.joint_traits[1];
  follower.q_open = multiplier * master.q_open;
  follower.q_sphere = multiplier * master.q_sphere;
  follower.q_closed = multiplier * master.q_closed;
  return p;
}

/// Both driving vectors of the front slider's slots ask for d_front, those of the back slider's for d_back.
std::vector<double> action_for(double d_front, double d_back) {
  std::vector<double> action(15, d_front);
  std::fill_n(action.begin(), 5, 0.0);
  std::fill_n(action.begin() + 13, 2, d_back);
  return action;
}

/// The small hand with its last index joint on the lateral joint's motor: q_2 = 0.5 q_0 + 0.6.
HandProfile follower_of_the_lateral_joint() {
  HandProfile p = test::small_profile();
  Joint& follower = p.tree.joints[2];
  follower.mimic_master = 0;
  follower.mimic_multiplier = 0.5;
  follower.mimic_offset = 0.6;
  const JointTraits& master = p.joint_traits[0];
  JointTraits& traits = p.joint_traits[2];
  traits.joint_class = JointClass::lateral;
  traits.q_open = 0.5 * master.q_open + 0.6;
  traits.q_sphere = 0.5 * master.q_sphere + 0.6;
  traits.q_closed = 0.5 * master.q_closed + 0.6;
  test::place_on_sphere(p);
  return p;
}

}  // namespace

TEST_CASE("a master of two fingers is fitted to the points of both") {
  for (const double multiplier : {1.0, 0.5, -0.5}) {
    CAPTURE(multiplier);
    const HandProfile profile = coupled_sliders(multiplier);
    for (const auto& [d_front, d_back] : {std::pair{0.1, 0.2}, {-0.1, 0.3}, {0.2, -0.25}}) {
      // the least (q - d_front)^2 + (multiplier q - d_back)^2
      const double expected = (d_front + multiplier * d_back) / (1 + multiplier * multiplier);
      const std::vector<double> q = solve(profile, action_for(d_front, d_back));
      CHECK(q[0] == doctest::Approx(expected).epsilon(1e-9));
      CHECK(q[1] == doctest::Approx(multiplier * expected).epsilon(1e-9));
    }
  }
}

TEST_CASE("a follower of a lateral joint goes with it, alone and in lanes") {
  const HandProfile profile = follower_of_the_lateral_joint();
  const LateralTable& table = profile.lateral_tables[0];
  CHECK_NOTHROW(validate_profile(profile, "hand.h5"));
  for (const double delta_theta : {-0.3, -0.1, 0.0, 0.2}) {
    CAPTURE(delta_theta);
    std::vector<double> action(15, 0.05);
    std::fill_n(action.begin(), 4, delta_theta);
    const std::vector<double> q = solve(profile, action);
    CHECK(q[0] == doctest::Approx(look_up_lateral<double>(table.inverse_q, table.delta_theta_lower,
                                                          table.delta_theta_upper, delta_theta)));
    CHECK(q[2] == doctest::Approx(0.5 * q[0] + 0.6));
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
      if (!is_available(set)) continue;
      const std::vector<double> in_lanes = solve_in_lanes(profile, action, set);
      for (std::size_t i = 0; i < q.size(); ++i) CHECK(in_lanes[i] == doctest::Approx(q[i]).epsilon(1e-6));
    }
  }
}
