// Solves actions and states the solutions as JSON (schemas/solution.schema.json).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/json_text.hpp"
#include "uhas/collision/collision_free_solver.hpp"

namespace uhas::tools {

/// Which joints a solution lists, and in which order.
struct JointSelection {
  std::vector<std::string> order;  ///< joint names; empty = all, in the profile's order
  bool actuated_only = false;      ///< leaves mimic followers out
};

/// What is done about self-collision.
struct CollisionUse {
  const SelfCollision* hand = nullptr;  ///< of the same hand, outlives the maker; null = nothing is done
  bool report = false;                  ///< states the nearest links of each solution
  bool avoid = false;                   ///< scales back actions whose solution collides
};

/// A solver with its buffers and the joints to be shown.
class SolutionMaker {
 public:
  /// Throws Error(invalid_profile) as CascadeSolver, CLI::ParseError when `selection` names what the hand lacks.
  SolutionMaker(const HandProfile& profile, const SolveOptions& options, const JointSelection& selection,
                const CollisionUse& collision = {});

  std::vector<std::string> joint_names() const;

  /// One element of "solutions". `place` ("actions.json: action 3", or empty) opens the message of an error.
  /// Throws Error(invalid_action) when the solver refuses the action.
  Json solve(const Action<double>& action, const std::string& place);

  /// A sentence each on the solutions so far that were scaled back, and on those that could not be.
  std::vector<std::string> warnings() const;

 private:
  Json names_where(const std::vector<std::uint8_t>& flags) const;
  Json nearest_links() const;

  CascadeSolver<double> solver_;
  CollisionUse collision_;
  std::optional<CollisionFreeSolver> free_solver_;
  std::size_t solved_ = 0, scaled_ = 0, colliding_ = 0;
  std::vector<std::string> link_names_;
  std::vector<std::string> names_;  ///< every joint of the profile
  std::vector<int> selected_;       ///< indices of the joints to be shown
  std::vector<double> q_;
  std::vector<std::uint8_t> at_limit_, closed_;
};

}  // namespace uhas::tools
