// Solves actions and states the solutions as JSON (schemas/solution.schema.json).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/model_input.hpp"
#include "uhas/collision/collision_free_solver.hpp"
#include "uhas/json/json_text.hpp"

namespace uhas::tools {

/// Which joints a solution lists, and in which order.
struct JointSelection {
  std::vector<std::string> order;  ///< joint names; empty = all, in the profile's order
  bool actuated_only = false;      ///< leaves mimic followers out
};

/// What is done about self-collision; either needs the meshes of the hand's model.
struct CollisionUse {
  bool report = false;  ///< states the nearest links of each solution
  bool avoid = false;   ///< scales back actions whose solution collides
};

/// A solver with its buffers and the joints to be shown.
class SolutionMaker {
 public:
  /// Throws Error(invalid_profile) as CascadeSolver, CLI::ParseError when `selection` names what the hand lacks, what
  /// `load_self_collision` throws when that is needed.
  SolutionMaker(Tool& tool, ProfileFile file, const SolveOptions& options, const JointSelection& selection,
                const CollisionUse& collision, const ModelInput& model);

  const ProfileFile& file() const { return file_; }
  std::vector<std::string> joint_names() const;

  /// One element of "solutions". `place` ("actions.json: action 3", or empty) opens the message of an error.
  /// Throws Error(invalid_action) when the solver refuses the action.
  Json solve(const Action<double>& action, const std::string& place);

  /// Numbers of the action last solved: with `CollisionUse::avoid` what was left of it.
  const std::vector<double>& solved_values() const { return solved_values_; }

  /// A sentence each on the solutions so far that were scaled back, and on those that could not be.
  std::vector<std::string> warnings() const;

 private:
  Json names_where(const std::vector<std::uint8_t>& flags) const;
  Json nearest_links() const;

  ProfileFile file_;
  CascadeSolver<double> solver_;
  CollisionUse collision_use_;
  std::optional<SelfCollision> collision_;
  std::optional<CollisionFreeSolver> free_solver_;
  std::size_t solved_ = 0, scaled_ = 0, colliding_ = 0;
  std::vector<double> solved_values_;
  std::vector<std::string> names_;  ///< every joint of the profile
  std::vector<int> selected_;       ///< indices of the joints to be shown
  std::vector<double> q_;
  std::vector<std::uint8_t> at_limit_, closed_;
};

}  // namespace uhas::tools
