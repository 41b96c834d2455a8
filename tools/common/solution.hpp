// Solves actions and states the solutions as JSON (schemas/solution.schema.json).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/json_text.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas::tools {

/// Which joints a solution lists, and in which order.
struct JointSelection {
  std::vector<std::string> order;  ///< joint names; empty = all, in the profile's order
  bool actuated_only = false;      ///< leaves mimic followers out
};

/// A solver with its buffers and the joints to be shown.
class SolutionMaker {
 public:
  /// Throws Error(invalid_profile) as CascadeSolver, CLI::ParseError when `selection` names what the hand lacks.
  SolutionMaker(const HandProfile& profile, const SolveOptions& options, const JointSelection& selection);

  std::vector<std::string> joint_names() const;

  /// One element of "solutions". `place` ("actions.json: action 3", or empty) opens the message of an error.
  /// Throws Error(invalid_action) when the solver refuses the action.
  Json solve(const Action<double>& action, const std::string& place);

 private:
  Json names_where(const std::vector<std::uint8_t>& flags) const;

  CascadeSolver<double> solver_;
  std::vector<std::string> names_;  ///< every joint of the profile
  std::vector<int> selected_;       ///< indices of the joints to be shown
  std::vector<double> q_;
  std::vector<std::uint8_t> at_limit_, closed_;
};

}  // namespace uhas::tools
