// Reads actions (schemas/actions.schema.json): strict, so that a wrong number never reaches a hand.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "command_line/limits.hpp"
#include "uhas/json/json_text.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas::tools {

/// The conventions that actions may be in, by name.
struct NamedConvention {
  const char* name;
  SolveOptions options;  ///< the convention, with the rule and the closing it is made for
};
inline constexpr NamedConvention kConventions[] = {{"uhas", kUhas}, {"uhas-sim", kUhasSim}};

/// A file of actions, all with the same number V of driving vectors.
struct ActionsDocument {
  std::string profile;  ///< path of the hand profile, relative to the actions file if it was so; empty = not stated
  std::vector<double> driving_vectors_phi;  ///< [V] or [5 V]; empty = the default angles
  bool normalized = false;
  SolveOptions convention = kUhas;           ///< one of `kConventions`
  std::vector<std::vector<double>> actions;  ///< [5 + 5 V] each

  Action<double> action(std::size_t index) const { return {actions[index], driving_vectors_phi, normalized}; }
};

/// Throws Error: file_unreadable, limit_exceeded, syntax, invalid_action naming the file and the action.
ActionsDocument read_actions(const std::string& path, const Limits& limits = {});

/// The action that `value`, an array or an object, is. Throws Error(invalid_action).
std::vector<double> action_of(const Json& value);

}  // namespace uhas::tools
