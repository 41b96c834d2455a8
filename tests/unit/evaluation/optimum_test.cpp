#include "uhas/evaluation/least_squares/optimum.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/slider_profile.hpp"

using namespace uhas;

namespace {

/// The front finger becomes a hinge at (0.5, 0, 0) about y with its point half a metre further out.
HandProfile hinge_profile() {
  HandProfile profile = test::slider_profile();
  Joint& joint = profile.tree.joints[0];
  joint.kind = JointKind::revolute;
  joint.axis = {0, 1, 0};
  joint.T_parent_joint.translation = {0.5, 0, 0};
  joint.lower = -1, joint.upper = 1.2;
  profile.joint_traits[0].q_open = -1, profile.joint_traits[0].q_closed = 1.2;
  profile.fingers[0].p_tip_link = {0.5, 0, 0};
  profile.correspondences[0].p_link = {0.5, 0, 0};
  return profile;
}

/// All displacements alike.
std::vector<double> squeezed(double delta_r) {
  std::vector<double> action(15, delta_r);
  std::fill_n(action.begin(), 5, 0.0);
  return action;
}

}  // namespace

TEST_CASE("starts that agree are an optimum that can be trusted") {
  const HandProfile profile = hinge_profile();
  std::vector<LeastSquares> problems = LeastSquares::of_hand(profile);
  problems[0].set_action(squeezed(-0.2));
  // at q the squared distance is (0.5 cos q + 0.5 - 0.8)^2 + (0.5 sin q)^2 = 0.34 - 0.3 cos q
  const Optimum optimum =
      find_optimum(profile, problems[0], std::vector<std::vector<double>>{{0.7, 0}, {-0.9, 0}, {1.2, 0}});
  CHECK(optimum.rms == doctest::Approx(0.2));
  CHECK(optimum.second_rms == doctest::Approx(0.2));
  CHECK(optimum.q[0] == doctest::Approx(0).epsilon(1e-5));
}

TEST_CASE("starts that end in different minima are told apart") {
  const HandProfile profile = hinge_profile();
  std::vector<LeastSquares> problems = LeastSquares::of_hand(profile);
  // the target passes behind the hinge: the squared distance is 0.26 + 0.1 cos q, least at either limit
  problems[0].set_action(squeezed(-0.6));
  const Optimum optimum = find_optimum(profile, problems[0], std::vector<std::vector<double>>{{0.5, 0}, {-0.5, 0}});
  CHECK(optimum.rms == doctest::Approx(std::sqrt(0.26 + 0.1 * std::cos(1.2))));
  CHECK(optimum.second_rms == doctest::Approx(std::sqrt(0.26 + 0.1 * std::cos(1.0))));
  CHECK(optimum.q[0] == doctest::Approx(1.2));
}
