// A hand to be measured, and the input that everything measured on it shares.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::benchmark {

/// Actions and what the solver makes of them; rows of one array, in double.
struct ActionSet {
  std::vector<double> actions;     ///< [count][15]
  std::vector<double> q;           ///< [count][joints] rad, m for prismatic joints
  std::vector<double> fingertips;  ///< [count][fingers][3] m, palm frame: reachable targets for other solvers
};

struct HandCase {
  std::filesystem::path urdf;
  HandProfile profile;
  std::size_t count = 0;      ///< actions of each set
  ActionSet gentle;           ///< independent draws: any d theta, |d r| <= 0.5, where no point fades
  ActionSet any;              ///< independent draws: any d theta, |d r| <= 2, the whole range
  ActionSet closing;          ///< independent draws: any d theta, d r in [-1, -0.5], where points of every finger fade
  ActionSet trajectory;       ///< a smooth motion through gentle actions: 25 steps from one draw to the next
  std::vector<double> rates;  ///< [count][joints] rad/s, m/s

  std::size_t joints() const { return profile.tree.joints.size(); }
  std::size_t fingers() const { return profile.fingers.size(); }
};

/// Builds the profile of `urdf` and draws `count` actions a set; the same seed gives the same case.
HandCase make_hand_case(const std::filesystem::path& urdf, std::size_t count, unsigned seed);

/// The hands to measure: those in the repository's folder `hands`, then, if it is not empty, those in `shared_hands` (a
/// folder a hand with its URDF named in truth.json), in the order of their names.
/// Throws std::runtime_error when `shared_hands` holds none.
std::vector<std::filesystem::path> find_hands(const std::filesystem::path& own_hands,
                                              const std::filesystem::path& shared_hands);

}  // namespace uhas::benchmark
